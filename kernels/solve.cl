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

// The first tiling, which begins with the circles' own share. `moves`: a substep comes before this one. `members`: the circles
// of each tile, which are counted after all `tiles` of contacts.
__kernel void c2d_solve_first(C2D_SOLVE, __global const int *members, int tiles, int moves) {
    const int tile = (int)get_group_id(0);
    const int contacts = tileStart[C2D_PARTS * tiles];
    const int end = tileStart[C2D_PARTS * (tiles + tile + 1)] - contacts;
    int m = tileStart[C2D_PARTS * (tiles + tile)] - contacts + (int)get_local_id(0);
    for (; m < (status[C2D_STALLED] != 0u ? 0 : end); m += (int)get_local_size(0)) {
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
