// Contacts that neither of the first two tilings holds, where there are three: each crosses a border of the first along one axis
// and one of the second along the other, so that they are few. They are solved in the launch of the second tiling, before its own:
// each tile of it that has one of their circles solves all that are near, from the same copies, the same way, and keeps what
// is its own. The copies are made in the launch before. Saves a launch a substep. Tiles of the three tilings lie by pipeline.Tiles.

// The circles of a crossing contact after the first tiling, and what is remembered of it then; in the order of solving.
#define C2D_COPIES C2D_AT(float8, crossing)
#define C2D_COPIED C2D_AT(float2, found)
// The crossing contact of a lane of `tile`, or -1.
static int c2d_crossing_of(int lane, int tile, int tiling, C2D_WORLD) {
    const int last = c2d_around(tile, tiling, lane / C2D_CROSSING, false, C2D_TILING_TABLE);
    const int e = C2D_TILE_START[C2D_PARTS * last] + lane % C2D_CROSSING;
    return e < C2D_TILE_START[C2D_PARTS * (last + 1)] ? e : -1;
}

// Copies what crossing contacts need of a tile of the first tiling, which is done. By one work-group.
static void c2d_crossing_copy(int tile, C2D_WORLD) {
    const int before = c2d_crossing_first(heap, status, world);
    for (int lane = (int)get_local_id(0); lane < C2D_LANES; lane += (int)get_local_size(0)) {
        const int e = c2d_crossing_of(lane, tile, 0, heap, status, world);
        if (e >= 0) {
            const int which = lane / C2D_CROSSING;
            const int roles = C2D_ROLES[e];
            const int k = C2D_SOLVED[e];
            if (C2D_ROLE(roles, 0, 0) == which) {
                C2D_COPIES[2 * (e - before)] = C2D_BODY[C2D_BATCH[k]];
            }
            if (C2D_ROLE(roles, 0, 1) == which) {
                C2D_COPIES[2 * (e - before) + 1] = C2D_BODY[C2D_OTHER[k]];
            }
            if (which == 0) {
                C2D_COPIED[e] = C2D_MEMORY[e];
            }
        }
    }
}

// What a visit made of a circle goes to the next contact of it, or, after the last, to the tile that has the circle.
static void c2d_crossing_pass(int at, float8 now, bool isOwn, __global float8 *body, __local float8 *bodies,
                              __local const int *places) {
    const int place = places[at];
    const int end = (at / (2 * C2D_CROSSING) + 1) * 2 * C2D_CROSSING;
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

// The crossing contacts around a tile of the second tiling, a colour at a time, by one work-group. `bodies`, `places`: of both
// circles of each lane; then of each lane its contact, and its roles; then how many colours there are.
static void c2d_crossing_solve(int tile, C2D_WORLD, __local float8 *bodies, __local int *places) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const int before = c2d_crossing_first(heap, status, world);
    const c2d_numbers numbers = c2d_numbers_of(C2D_RULE);
    __local int *contact = places + 2 * C2D_LANES;
    __local int *roles = contact + C2D_LANES;
    __local int *colours = roles + C2D_LANES;
    if (item == 0) {
        *colours = 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int lane = item; lane < C2D_LANES; lane += items) {
        const int e = c2d_crossing_of(lane, tile, 1, heap, status, world);
        places[2 * lane] = -1;
        places[2 * lane + 1] = -1;
        contact[lane] = e;
        if (e >= 0) {
            const int k = C2D_SOLVED[e];
            places[2 * lane] = C2D_BATCH[k];
            places[2 * lane + 1] = C2D_OTHER[k];
            bodies[2 * lane] = C2D_COPIES[2 * (e - before)];
            bodies[2 * lane + 1] = C2D_COPIES[2 * (e - before) + 1];
            roles[lane] = C2D_ROLES[e];
            atomic_max(colours, C2D_ROLE_COLOUR(roles[lane]) + 1);
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    const int most = *colours;
    for (int colour = 0; colour < most; colour++) {
        for (int lane = item; lane < C2D_LANES; lane += items) {
            const int e = contact[lane];
            if (e >= 0 && C2D_ROLE_COLOUR(roles[lane]) == colour) {
                const int which = lane / C2D_CROSSING;
                float8 a = bodies[2 * lane];
                float8 b = bodies[2 * lane + 1];
                float2 remembered = C2D_COPIED[e];
                c2d_visit(&a, &b, &remembered, places[2 * lane], places[2 * lane + 1], C2D_ID, C2D_KICKED, numbers);
                c2d_crossing_pass(2 * lane, a, C2D_ROLE(roles[lane], 1, 0) == which, C2D_BODY, bodies, places);
                c2d_crossing_pass(2 * lane + 1, b, C2D_ROLE(roles[lane], 1, 1) == which, C2D_BODY, bodies, places);
                if (which == 0) {
                    C2D_MEMORY[e] = remembered;
                }
            }
        }
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
}
