// The substeps: the circles' own share, integrate.cl, then one pass over the contacts, whose rule is in visit.cl.
// Solver.SMALL_STEPS. Twin of host.Solve.

#define C2D_SOLVE                                                                                                      \
    C2D_CIRCLES, __global float2 *memory, __global const int2 *pairs, int capacity, __global const int *batch,           \
        __global const int *tileStart, __global const int *tileColours, __global const uint *status
#define C2D_SOLVE_HERE                                                                                                 \
    body, id, kicked, walls, rule, memory, pairs, capacity, batch, tileStart, tileColours, status

// The contacts of a tile, a colour at a time, by one work-group. Memory is slow, so that each work-item reads what it needs of
// its contact of the next colour, but the circles, before this colour is done.
static void c2d_solve_tile(int tile, c2d_numbers numbers, C2D_SOLVE) {
    const int first = tileStart[C2D_PARTS * tile];
    const int end = tileStart[C2D_PARTS * (tile + 1)];
    const int colours = status[C2D_STALLED] != 0u || first == end ? 0 : tileColours[tile];
    const int items = (int)get_local_size(0);
    __global const int *index = batch + capacity;
    __global const int *colourStart = batch + 2 * capacity + first;
    int e = first + (int)get_local_id(0);
    int stop = colours > 1 ? colourStart[1] : end;
    int k = e < stop ? index[e] : 0;
    int2 pair = e < stop ? pairs[e] : (int2)(0, 0);
    float2 remembered = e < stop ? memory[k] : (float2)(0.0f, 0.0f);
    for (int colour = 0; colour < colours; colour++) {
        const int nextE = stop + (int)get_local_id(0);
        const int nextStop = colour + 2 < colours ? colourStart[colour + 2] : end;
        const int nextK = nextE < nextStop ? index[nextE] : 0;
        const int2 nextPair = nextE < nextStop ? pairs[nextE] : (int2)(0, 0);
        const float2 nextRemembered = nextE < nextStop ? memory[nextK] : (float2)(0.0f, 0.0f);
        while (e < stop) {
            float8 a = body[pair.x];
            float8 b = body[pair.y];
            if (c2d_visit(&a, &b, &remembered, pair.x, pair.y, id, kicked, numbers)) {
                body[pair.x] = a;
                body[pair.y] = b;
                memory[k] = remembered;
            }
            e += items;
            if (e < stop) {
                k = index[e];
                pair = pairs[e];
                remembered = memory[k];
            }
        }
        barrier(CLK_GLOBAL_MEM_FENCE);
        e = nextE;
        stop = nextStop;
        k = nextK;
        pair = nextPair;
        remembered = nextRemembered;
    }
}

// A tiling after the first, one work-group a tile.
__kernel void c2d_solve(C2D_SOLVE, int firstTile) {
    c2d_solve_tile(firstTile + (int)get_group_id(0), c2d_numbers_of(rule), C2D_SOLVE_HERE);
}

// The first tiling, which begins with the circles of each tile. `moves`: a substep comes before this one. `members` by tile,
// after all `tiles` of contacts.
__kernel void c2d_solve_first(C2D_SOLVE, __global const int *members, int tiles, int moves) {
    const int tile = (int)get_group_id(0);
    const int contacts = tileStart[C2D_PARTS * tiles];
    const int end = tileStart[C2D_PARTS * (tiles + tile + 1)] - contacts;
    int m = tileStart[C2D_PARTS * (tiles + tile)] - contacts + (int)get_local_id(0);
    for (; m < (status[C2D_STALLED] != 0u ? 0 : end); m += (int)get_local_size(0)) {
        c2d_integrate_circle(members[m], moves, true, body, id, kicked, walls, rule);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    c2d_solve_tile(tile, c2d_numbers_of(rule), C2D_SOLVE_HERE);
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
