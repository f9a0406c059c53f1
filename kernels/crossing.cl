// Contacts that neither of the first two tilings holds, where there are three: each crosses a border of the first along one axis
// and one of the second along the other, so that they are few. They are solved in the launch of the second tiling, before its own:
// each tile of it that has one of their circles solves all that are near, from the same copies, the same way, and keeps what
// is its own. The copies are made in the launch before. That saves a launch a substep, on a
// GPU; processors have one, which costs them less. Which are near which tile: batch_order.cl.

// In the order of solving: the circles of a crossing contact after the first tiling, and what is remembered of it then.
#define C2D_COPIES C2D_AT(float8, crossing)
#define C2D_COPIED C2D_AT(float2, found)

static int c2d_crossing_near(int which, int8 tile) { return which == 0 ? tile.s5 : which == 1 ? tile.s6 : tile.s7; }

// The crossing contact of a lane of a tile, or -1.
static int c2d_crossing_of(int lane, int8 tile) {
    const int near = c2d_crossing_near(lane / C2D_CROSSING, tile);
    return lane % C2D_CROSSING < C2D_NEAR_COUNT(near) ? C2D_NEAR_FIRST(near) + lane % C2D_CROSSING : -1;
}

// Copies what crossing contacts need of a tile of the first tiling, which is done. By one work-group; `own` is that of its lane.
static void c2d_crossing_copy(int8 tile, int4 own, C2D_WORLD) {
    for (int lane = (int)get_local_id(0); lane < C2D_LANES; lane += (int)get_local_size(0)) {
        const int c = c2d_crossing_of(lane, tile);
        if (c >= 0) {
            const int role = lane / C2D_CROSSING + 1;
            const int4 now = lane == (int)get_local_id(0) ? own : C2D_CROSSES[c];
            if (C2D_ROLE(now.z, 0, 0) == role) {
                C2D_COPIES[2 * c] = C2D_BODY[now.x];
            }
            if (C2D_ROLE(now.z, 0, 1) == role) {
                C2D_COPIES[2 * c + 1] = C2D_BODY[now.y];
            }
            // there is a circle in that tile, always
            if (role == 3) {
                C2D_COPIED[c] = C2D_MEMORY[now.w];
            }
        }
    }
}

// Crossing contacts in local memory: of each lane both circles, `bodies`, then what is remembered; their `places`, and then of each
// lane the roles.
#define C2D_LANE_MEMORY(bodies) ((__local float2 *)((bodies) + 2 * C2D_LANES))
#define C2D_LANE_ROLES(places) ((places) + 2 * C2D_LANES)

// Reads those near a tile of the second tiling; how many colours they may have. By one work-group.
static int c2d_crossing_read(int8 tile, C2D_WORLD, __local float8 *bodies, __local int *places) {
    const int item = (int)get_local_id(0);
    __local int *most = places + 3 * C2D_LANES;
    if (C2D_NEAR_COUNT(tile.s5) + C2D_NEAR_COUNT(tile.s6) + C2D_NEAR_COUNT(tile.s7) == 0) {
        return 0;
    }
    if (item == 0) {
        *most = 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int lane = item; lane < C2D_LANES; lane += (int)get_local_size(0)) {
        const int c = c2d_crossing_of(lane, tile);
        const int4 own = c < 0 ? (int4)(-1, -1, -1, -1) : C2D_CROSSES[c];
        places[2 * lane] = own.x;
        places[2 * lane + 1] = own.y;
        C2D_LANE_ROLES(places)[lane] = own.z;
        if (c >= 0) {
            bodies[2 * lane] = C2D_COPIES[2 * c];
            bodies[2 * lane + 1] = C2D_COPIES[2 * c + 1];
            C2D_LANE_MEMORY(bodies)[lane] = C2D_COPIED[c];
            atomic_max(most, C2D_ROLE_COLOUR(own.z) + 1);
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    return *most;
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

// Keeps what a visit made of the contact of a lane.
static void c2d_crossing_keep(int lane, int8 tile, float8 a, float8 b, float2 remembered, __global float8 *body,
                              __global float2 *memory, __global const int4 *crosses, __local float8 *bodies,
                              __local const int *places) {
    const int role = lane / C2D_CROSSING;
    const int roles = C2D_LANE_ROLES(places)[lane];
    const int end = 2 * (C2D_CROSSING * role + C2D_NEAR_COUNT(c2d_crossing_near(role, tile)));
    c2d_crossing_pass(2 * lane, end, a, C2D_ROLE(roles, 1, 0) == role, body, bodies, places);
    c2d_crossing_pass(2 * lane + 1, end, b, C2D_ROLE(roles, 1, 1) == role, body, bodies, places);
    // there is a circle in that tile, too
    if (role == 0) {
        memory[crosses[c2d_crossing_of(lane, tile)].w] = remembered;
    }
}
