// The substeps: the circles' own share, integrate.cl, then one pass over the contacts, whose rule is in visit.cl.
// Solver.SMALL_STEPS. Twin of host.Solve.

#define C2D_SOLVE                                                                                                      \
    C2D_CIRCLES, __global float2 *memory, __global const int2 *pairs, int capacity, __global const int *batch,           \
        __global const int *tileStart, __global const int *tileColours, __global const uint *status
#define C2D_SOLVE_HERE                                                                                                 \
    body, id, kicked, walls, rule, memory, pairs, capacity, batch, tileStart, tileColours, status

static int c2d_solve_colours(int tile, __global const int *tileStart, __global const int *tileColours) {
    return tileStart[C2D_PARTS * tile] == tileStart[C2D_PARTS * (tile + 1)] ? 0 : tileColours[tile];
}

// The contacts of a tile, a colour at a time, by work-items 0 to `items` - 1 of those that do this tile. `rounds`: the most
// colours of any tile that the group does.
static void c2d_solve_tile(int tile, int item, int items, int colours, int rounds, C2D_SOLVE) {
    const int first = colours == 0 ? 0 : tileStart[C2D_PARTS * tile];
    const int end = colours == 0 ? 0 : tileStart[C2D_PARTS * (tile + 1)];
    const c2d_numbers numbers = c2d_numbers_of(rule);
    __global const int *index = batch + capacity;
    __global const int *colourStart = batch + 2 * capacity + first;
    for (int colour = 0; colour < rounds; colour++) {
        const int start = colour < colours ? colourStart[colour] : end;
        const int stop = colour + 1 < colours ? colourStart[colour + 1] : end;
        for (int e = start + item; e < stop; e += items) {
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
__kernel void c2d_solve(C2D_SOLVE, int firstTile) {
    const int tile = firstTile + (int)get_group_id(0);
    if (status[C2D_STALLED] == 0u) {
        const int colours = c2d_solve_colours(tile, tileStart, tileColours);
        c2d_solve_tile(tile, (int)get_local_id(0), (int)get_local_size(0), colours, colours, C2D_SOLVE_HERE);
    }
}

// The circles' own share of a substep, for those of a tile of the first tiling. `moves`: a substep comes before this one.
// `members`: the circles of each tile, which are counted after all `tiles` of contacts.
static void c2d_solve_members(int tile, int item, int items, int moves, __global const int *members, int tiles, C2D_SOLVE) {
    const int contacts = tileStart[C2D_PARTS * tiles];
    const int end = tileStart[C2D_PARTS * (tiles + tile + 1)] - contacts;
    for (int m = tileStart[C2D_PARTS * (tiles + tile)] - contacts + item; m < end; m += items) {
        c2d_integrate_circle(members[m], moves, true, body, id, kicked, walls, rule);
    }
}

// The first tiling where circles are few and a launch counts: it begins with the circles' own share.
__kernel void c2d_solve_first(C2D_SOLVE, __global const int *members, int tiles, int moves) {
    const int tile = (int)get_group_id(0);
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    if (status[C2D_STALLED] == 0u) {
        c2d_solve_members(tile, item, items, moves, members, tiles, C2D_SOLVE_HERE);
        barrier(CLK_GLOBAL_MEM_FENCE);
        const int colours = c2d_solve_colours(tile, tileStart, tileColours);
        c2d_solve_tile(tile, item, items, colours, colours, C2D_SOLVE_HERE);
    }
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
