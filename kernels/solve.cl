// The substeps: the circles' own share, integrate.cl, then one pass over the contacts, whose rule is in visit.cl.
// Solver.SMALL_STEPS. Twin of host.Solve.

#define C2D_SOLVE                                                                                                      \
    C2D_CIRCLES, __global float2 *memory, __global const int2 *pairs, int capacity, __global const int *batch,           \
        __global const int *tileStart, __global const int *tileColours, __global const uint *status
#define C2D_SOLVE_HERE                                                                                                 \
    body, id, kicked, walls, rule, memory, pairs, capacity, batch, tileStart, tileColours, status

// The contacts of a tile, a colour at a time, by one work-group.
static void c2d_solve_tile(int tile, C2D_SOLVE) {
    const int first = tileStart[C2D_PARTS * tile];
    const int end = tileStart[C2D_PARTS * (tile + 1)];
    const int colours = status[C2D_STALLED] != 0u || first == end ? 0 : tileColours[tile];
    const c2d_numbers numbers = c2d_numbers_of(rule);
    __global const int *index = batch + capacity;
    __global const int *colourStart = batch + 2 * capacity + first;
    for (int colour = 0; colour < colours; colour++) {
        const int stop = colour + 1 < colours ? colourStart[colour + 1] : end;
        for (int e = colourStart[colour] + (int)get_local_id(0); e < stop; e += (int)get_local_size(0)) {
            const int2 pair = pairs[e];
            const int k = index[e];
            float8 a = body[pair.x];
            float8 b = body[pair.y];
            float2 remembered = memory[k];
            if (c2d_visit(&a, &b, &remembered, pair.x, pair.y, id, kicked, numbers)) {
                body[pair.x] = a;
                body[pair.y] = b;
                memory[k] = remembered;
            }
        }
        barrier(CLK_GLOBAL_MEM_FENCE);
    }
}

// A tiling, one work-group a tile.
__kernel void c2d_solve(C2D_SOLVE, int firstTile) { c2d_solve_tile(firstTile + (int)get_group_id(0), C2D_SOLVE_HERE); }

// A tile that fits into local memory: `bodies` and `places` of its circles, what is `remembered` of its contacts and whether that
// has changed. Each is read and written once, those of a row together, whatever the colours are.
static void c2d_solve_local(int tile, int2 own, int moves, C2D_SOLVE, __global const int *members,
                            __global const int *byTile, __local float8 *bodies, __local int *places,
                            __local float2 *remembered, __local uchar *changed) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const int first = tileStart[C2D_PARTS * tile];
    const int contacts = tileStart[C2D_PARTS * (tile + 1)] - first;
    const int colours = contacts > 0 ? tileColours[tile] : 0;
    const c2d_numbers numbers = c2d_numbers_of(rule);
    __global const int *colourStart = batch + 2 * capacity + first;
    for (int c = item; c < contacts; c += items) {
        remembered[c] = memory[byTile[first + c]];
        changed[c] = 0;
    }
    for (int m = item; m < own.y - own.x; m += items) {
        const int place = members[own.x + m];
        places[m] = place;
        bodies[m] = c2d_integrated(place, moves, true, body, id, kicked, walls, rule);
    }
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    for (int colour = 0; colour < colours; colour++) {
        const int stop = colour + 1 < colours ? colourStart[colour + 1] : first + contacts;
        for (int e = colourStart[colour] + item; e < stop; e += items) {
            const int2 pair = pairs[e];
            const int turnA = pair.x & ((1 << C2D_TURN_BITS) - 1);
            const int turnB = pair.x >> C2D_TURN_BITS;
            float8 a = bodies[turnA];
            float8 b = bodies[turnB];
            float2 now = remembered[pair.y];
            if (c2d_visit(&a, &b, &now, places[turnA], places[turnB], id, kicked, numbers)) {
                bodies[turnA] = a;
                bodies[turnB] = b;
                remembered[pair.y] = now;
                changed[pair.y] = 1;
            }
        }
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    for (int m = item; m < own.y - own.x; m += items) {
        body[places[m]] = bodies[m];
    }
    for (int c = item; c < contacts; c += items) {
        if (changed[c] != 0) {
            memory[byTile[first + c]] = remembered[c];
        }
    }
}

// The first tiling, which begins with the circles' own share. `moves`: a substep comes before this one. `members`: the circles
// of each tile.
__kernel void c2d_solve_first(C2D_SOLVE, __global const int *members, __global const int *byTile, int tiles, int moves,
                              __local float8 *bodies, __local int *places, __local float2 *remembered,
                              __local uchar *changed) {
    const int tile = (int)get_group_id(0);
    const bool stalled = status[C2D_STALLED] != 0u;
    const int2 own = stalled ? (int2)(0, 0) : c2d_members(tile, tiles, tileStart);
    const int contacts = stalled ? 0 : tileStart[C2D_PARTS * (tile + 1)] - tileStart[C2D_PARTS * tile];
    if (c2d_fits(own.y - own.x, contacts)) {
        c2d_solve_local(tile, own, moves, C2D_SOLVE_HERE, members, byTile, bodies, places, remembered, changed);
        return;
    }
    for (int m = own.x + (int)get_local_id(0); m < own.y; m += (int)get_local_size(0)) {
        body[members[m]] = c2d_integrated(members[m], moves, true, body, id, kicked, walls, rule);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    c2d_solve_tile(tile, C2D_SOLVE_HERE);
}

static float2 c2d_rescaled(float come, float last, float ratio) {
    return (float2)(come * ratio, last > 0.0f ? last * ratio : last);
}

// What impulses are worth in substeps of another time. One work-item a circle, going round where contacts are more.
__kernel void c2d_rescale(__global float8 *body, __global float2 *walls, __global float2 *memory,
                          __global const int *listStart, int circles, __global const float *rule) {
    const float ratio = C2D_RESCALE;
    const int i = (int)get_global_id(0);
    const int contacts = listStart[circles];
    for (int k = i; k < contacts; k += (int)get_global_size(0)) {
        memory[k] = c2d_rescaled(memory[k].x, memory[k].y, ratio);
    }
    if (i < circles) {
        for (int axis = 2 * i; axis < 2 * i + 2; axis++) {
            const float2 wall = walls[axis];
            walls[axis] = (float2)(wall.x * ratio, fabs(wall.y) < C2D_BOUNCED ? wall.y * ratio : wall.y);
        }
        body[i].s4 *= ratio;
        body[i].s5 *= ratio;
    }
}
