// Contacts that neither of the first two tilings holds, where there are three: each crosses a border of the first along one axis
// and one of the second along the other, so that they are few. They are solved in the launch of the second tiling, before its own:
// each tile of it that has one of their circles solves all that are near, from the same copies, the same way, and keeps what
// is its own. The copies are made in the launch before. That saves a launch a substep. Which are near which tile: batch_order.cl.

// In the order of solving: the circles of a crossing contact after the first tiling, and what is remembered of it then.
#define C2D_COPIES C2D_AT(float8, crossing)
#define C2D_COPIED C2D_AT(float2, found)

static int c2d_crossing_near(int which, int8 tile) { return which == 0 ? tile.s5 : which == 1 ? tile.s6 : tile.s7; }

// The crossing contact of a lane of a tile, or -1.
static int c2d_crossing_of(int lane, int8 tile) {
    const int near = c2d_crossing_near(lane / C2D_CROSSING, tile);
    return lane % C2D_CROSSING < C2D_NEAR_COUNT(near) ? C2D_NEAR_FIRST(near) + lane % C2D_CROSSING : -1;
}

// Copies what crossing contacts need of a tile of the first tiling, which is done. By one work-group.
static void c2d_crossing_copy(int8 tile, C2D_WORLD) {
    for (int lane = (int)get_local_id(0); lane < C2D_LANES; lane += (int)get_local_size(0)) {
        const int c = c2d_crossing_of(lane, tile);
        if (c >= 0) {
            const int role = lane / C2D_CROSSING + 1;
            const int4 own = C2D_CROSSES[c];
            if (C2D_ROLE(own.z, 0, 0) == role) {
                C2D_COPIES[2 * c] = C2D_BODY[own.x];
            }
            if (C2D_ROLE(own.z, 0, 1) == role) {
                C2D_COPIES[2 * c + 1] = C2D_BODY[own.y];
            }
            // there is a circle in that tile, always
            if (role == 3) {
                C2D_COPIED[c] = C2D_MEMORY[own.w];
            }
        }
    }
}

// What a visit made of a circle goes to the next contact of it, or, after the last, to the tile that has the circle.
static void c2d_crossing_pass(int at, int end, float8 now, bool isOwn, __global float8 *body, __local float8 *bodies,
                              __local const int *places) {
    const int place = places[at];
    int next = at + 1;
    while (next < end && places[next] != place) {
        next++;
    }
    if (next < end) {
        bodies[next] = now;
    } else if (isOwn) {
        body[place] = now;
    }
}

// The crossing contacts near a tile of the second tiling, a colour at a time, by one work-group. `bodies`, `places`: of both
// circles of each lane, then what is remembered of the contact, and how many colours there are.
static void c2d_crossing_solve(int8 tile, C2D_WORLD, __local float8 *bodies, __local int *places) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const c2d_numbers numbers = c2d_numbers_of(C2D_RULE);
    __local float2 *memory = (__local float2 *)(bodies + 2 * C2D_LANES);
    __local int *colours = places + 2 * C2D_LANES;
    if (C2D_NEAR_COUNT(tile.s5) + C2D_NEAR_COUNT(tile.s6) + C2D_NEAR_COUNT(tile.s7) == 0) {
        return;
    }
    if (item == 0) {
        *colours = 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int lane = item; lane < C2D_LANES; lane += items) {
        const int c = c2d_crossing_of(lane, tile);
        const int4 own = c < 0 ? (int4)(-1, -1, 0, 0) : C2D_CROSSES[c];
        places[2 * lane] = own.x;
        places[2 * lane + 1] = own.y;
        if (c >= 0) {
            bodies[2 * lane] = C2D_COPIES[2 * c];
            bodies[2 * lane + 1] = C2D_COPIES[2 * c + 1];
            memory[lane] = C2D_COPIED[c];
            atomic_max(colours, C2D_ROLE_COLOUR(own.z) + 1);
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    const int most = *colours;
    for (int colour = 0; colour < most; colour++) {
        for (int lane = item; lane < C2D_LANES; lane += items) {
            const int c = c2d_crossing_of(lane, tile);
            const int4 own = c < 0 ? (int4)(0, 0, -1, 0) : C2D_CROSSES[c];
            if (C2D_ROLE_COLOUR(own.z) == colour) {
                const int role = lane / C2D_CROSSING;
                const int end = 2 * (C2D_CROSSING * role + C2D_NEAR_COUNT(c2d_crossing_near(role, tile)));
                float8 a = bodies[2 * lane];
                float8 b = bodies[2 * lane + 1];
                float2 remembered = memory[lane];
                c2d_visit(&a, &b, &remembered, own.x, own.y, C2D_ID, C2D_KICKED, numbers);
                c2d_crossing_pass(2 * lane, end, a, C2D_ROLE(own.z, 1, 0) == role, C2D_BODY, bodies, places);
                c2d_crossing_pass(2 * lane + 1, end, b, C2D_ROLE(own.z, 1, 1) == role, C2D_BODY, bodies, places);
                // and in this one
                if (role == 0) {
                    C2D_MEMORY[own.w] = remembered;
                }
            }
        }
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
}
