// The substeps: the circles' own share, integrate.cl, then one pass over the contacts, whose rule is in visit.cl.
// Solver.SMALL_STEPS. Twin of host.Solve.

#define C2D_SOLVE                                                                                                      \
    __global float8 *body, C2D_CIRCLES, __global float2 *memory, __global const int *other, int capacity,                \
        __global const int *batch
#define C2D_NEXT_HERE(e, end) c2d_next_of(e, end, C2D_MEMORY, C2D_OTHER, world.capacity, C2D_BATCH)
#define C2D_SOLVE_HERE C2D_BODY, C2D_CIRCLES_HERE, C2D_MEMORY, C2D_OTHER, world.capacity, C2D_BATCH

// What a work-item of a GPU knows of its next contact before it solves this one: its circles, and what is remembered of it.
typedef struct {
    int2 pair;
    float2 memory;
} c2d_next;

static c2d_next c2d_next_of(int e, int end, __global const float2 *memory, __global const int *other, int capacity,
                            __global const int *batch) {
    c2d_next next = {(int2)(0, 0), (float2)(0.0f, 0.0f)};
    if (C2D_GPU && e < end) {
        const int k = batch[capacity + e];
        next.pair = (int2)(batch[k], other[k]);
        next.memory = memory[e];
    }
    return next;
}

// The contacts of a tile, a colour at a time, by one work-group; before them those `crossing` colours that are in local memory. On a
// GPU, a work-item reads which its next contact is, and what is remembered of it, before it solves this one: nobody else changes
// that. `next` is its first.
static void c2d_solve_tile(int8 tile, int crossing, c2d_next next, C2D_SOLVE, __global const int4 *crosses,
                           __local float8 *bodies, __local int *places) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const int colours = tile.s4 / 2;
    const c2d_numbers numbers = c2d_numbers_of(rule);
    __global const int *solved = batch + capacity;
    __global const int *colourStart = batch + 2 * capacity + tile.s0;
    int from = tile.s0;
    int stop = colours > 1 ? colourStart[1] : tile.s1;
    for (int colour = -crossing; colour < colours; colour++) {
        const bool isCrossing = colour < 0;
        const int nextStop = colour + 2 < colours ? colourStart[colour + 2] : tile.s1;
        const int to = isCrossing ? C2D_LANES : stop;
        for (int at = isCrossing ? 0 : from; at < to; at += items) {
            const int e = at + item;
            bool own = e < to;
            int2 pair = next.pair;
            float2 remembered = next.memory;
            float8 a;
            float8 b;
            if (isCrossing) {
                own = own && C2D_ROLE_COLOUR(C2D_LANE_ROLES(places)[e]) == colour + crossing;
                if (own) {
                    pair = (int2)(places[2 * e], places[2 * e + 1]);
                    remembered = C2D_LANE_MEMORY(bodies)[e];
                    a = bodies[2 * e];
                    b = bodies[2 * e + 1];
                }
            } else {
                if (!C2D_GPU && own) {
                    pair = (int2)(batch[solved[e]], other[solved[e]]);
                    remembered = memory[e];
                }
                next = c2d_next_of(min(at + items, stop) + item, nextStop, memory, other, capacity, batch);
                if (own) {
                    a = body[pair.x];
                    b = body[pair.y];
                }
            }
            if (own) {
                const bool changed = c2d_visit(&a, &b, &remembered, pair.x, pair.y, id, kicked, numbers);
                if (isCrossing) {
                    c2d_crossing_keep(e, tile, a, b, remembered, body, memory, crosses, bodies, places);
                } else if (changed) {
                    body[pair.x] = a;
                    body[pair.y] = b;
                    memory[e] = remembered;
                }
            }
        }
        if (!isCrossing) {
            from = stop;
            stop = nextStop;
        }
        barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    }
}

// Bodies in local memory, room for so many: on a GPU the halves apart from each other, so that circles whose places are far apart
// seldom share a bank; processors take nearly twice as long by that. By component: Oclgrind cannot put two vectors together.
#if C2D_GPU
static float8 c2d_body_of(__local const float8 *bodies, int m, int room) {
    __local const float4 *halves = (__local const float4 *)bodies;
    const float4 low = halves[m];
    const float4 high = halves[room + m];
    return (float8)(low.x, low.y, low.z, low.w, high.x, high.y, high.z, high.w);
}

static void c2d_body_to(__local float8 *bodies, int m, int room, float8 body) {
    __local float4 *halves = (__local float4 *)bodies;
    halves[m] = body.lo;
    halves[room + m] = body.hi;
}
#else
static float8 c2d_body_of(__local const float8 *bodies, int m, int room) { return bodies[m]; }

static void c2d_body_to(__local float8 *bodies, int m, int room, float8 body) { bodies[m] = body; }
#endif

// The same of a tile whose `bodies`, with `room` for so many, are in local memory. `places`: those of its circles, or null where
// they are the turns.
static void c2d_solve_bodies(int first, int end, int colours, __local float8 *bodies, int room, __local const int *places,
                             C2D_SOLVE) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const c2d_numbers numbers = c2d_numbers_of(rule);
    __global const int *solved = batch + capacity;
    __global const int *colourStart = batch + 2 * capacity + first;
    int nextPair = 0;
    float2 nextMemory = (float2)(0.0f, 0.0f);
    if (C2D_GPU && first + item < end) {
        nextPair = solved[first + item];
        nextMemory = memory[first + item];
    }
    int stop = colours > 1 ? colourStart[1] : end;
    for (int colour = 0, from = first; colour < colours; colour++) {
        const int nextStop = colour + 2 < colours ? colourStart[colour + 2] : end;
        for (; from < stop; from += items) {
            const int e = from + item;
            const bool own = e < stop;
            const int pair = C2D_GPU || !own ? nextPair : solved[e];
            float2 remembered = C2D_GPU || !own ? nextMemory : memory[e];
            const int next = min(from + items, stop) + item;
            if (C2D_GPU && next < nextStop) {
                nextPair = solved[next];
                nextMemory = memory[next];
            }
            if (own) {
                const int i = pair & ((1 << C2D_TURN_BITS) - 1);
                const int j = pair >> C2D_TURN_BITS;
                float8 a = c2d_body_of(bodies, i, room);
                float8 b = c2d_body_of(bodies, j, room);
                if (c2d_visit(&a, &b, &remembered, places == 0 ? i : places[i], places == 0 ? j : places[j], id, kicked, numbers)) {
                    c2d_body_to(bodies, i, room, a);
                    c2d_body_to(bodies, j, room, b);
                    memory[e] = remembered;
                }
            }
        }
        from = stop;
        stop = nextStop;
        barrier(CLK_LOCAL_MEM_FENCE);
    }
}

// A tile of the first tiling: the circles' own share, then its contacts; `copies` for crossing contacts. Where bodies fit into
// local memory they are read and written once, whatever the colours are.
static void c2d_solve_first_tile(int8 tile, bool move, bool copies, C2D_WORLD, __local float8 *bodies, __local int *places) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const int circles = tile.s3 - tile.s2;
    const bool fits = (tile.s4 & 1) != 0;
    // read early, for that takes a while
    const int lane = C2D_GPU && copies && item < C2D_LANES ? c2d_crossing_of(item, tile) : -1;
    const int4 crossing = lane < 0 ? (int4)(0, 0, 0, 0) : C2D_CROSSES[lane];
    for (int m = item; m < circles; m += items) {
        const int place = C2D_MEMBERS[tile.s2 + m];
        const float8 body = c2d_integrated(C2D_BODY[place], place, move, true, C2D_CIRCLES_HERE);
        if (fits) {
            c2d_body_to(bodies, m, C2D_TILE_CIRCLES, body);
            places[m] = place;
        } else {
            C2D_BODY[place] = body;
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    if (fits) {
        c2d_solve_bodies(tile.s0, tile.s1, tile.s4 / 2, bodies, C2D_TILE_CIRCLES, places, C2D_SOLVE_HERE);
        for (int m = item; m < circles; m += items) {
            C2D_BODY[places[m]] = c2d_body_of(bodies, m, C2D_TILE_CIRCLES);
        }
    } else {
        const c2d_next next = C2D_NEXT_HERE(tile.s0 + item, tile.s1);
        c2d_solve_tile(tile, 0, next, C2D_SOLVE_HERE, C2D_CROSSES, bodies, places);
    }
#if C2D_GPU
    barrier(CLK_GLOBAL_MEM_FENCE);
    if (copies) {
        c2d_crossing_copy(tile, crossing, heap, status, world);
    }
#endif
}

// The first tiling, work-groups as for batch_local.cl: the start of a substep, after the end of the one before if there is one, `move`.
// `crossing`: the last of three tilings has no launch.
__kernel void c2d_solve_first(C2D_WORLD, int move, __local float8 *bodies, __local int *places, int crossing) {
    const int group = (int)get_group_id(0);
    if (status[C2D_STALLED] != 0u) {
        return;
    }
    const bool copies = crossing && status[C2D_CROWDED] == 0u;
#if C2D_GPU
    for (int turn = group; turn < C2D_LIVE[0]; turn += (int)get_num_groups(0)) {
        c2d_solve_first_tile(C2D_SOLVES[turn], move, copies, heap, status, world, bodies, places);
        barrier(CLK_LOCAL_MEM_FENCE);
    }
#else
    c2d_solve_first_tile(C2D_SOLVES[group], move, copies, heap, status, world, bodies, places);
#endif
}

// A tile of another tiling, after the crossing contacts near it if it does those.
static void c2d_solve_other_tile(int8 tile, bool crossing, C2D_WORLD, __local float8 *bodies, __local int *places) {
    const c2d_next next = C2D_NEXT_HERE(tile.s0 + (int)get_local_id(0), tile.s1);
    const int colours = crossing ? c2d_crossing_read(tile, heap, status, world, bodies, places) : 0;
    c2d_solve_tile(tile, colours, next, C2D_SOLVE_HERE, C2D_CROSSES, bodies, places);
}

// Another tiling, which begins with tile `first`. Where crossing contacts are too many for it, one work-group does the last
// tiling and then this one.
__kernel void c2d_solve(C2D_WORLD, int tiling, int first, __local float8 *bodies, __local int *places, int crossing) {
    const int group = (int)get_group_id(0);
    if (status[C2D_STALLED] != 0u) {
        return;
    }
#if C2D_GPU
    const bool crowded = crossing && status[C2D_CROWDED] != 0u;
    const int groups = crowded ? 1 : (int)get_num_groups(0);
    for (int now = crowded ? 2 : tiling; now >= tiling; now--) {
        const int from = C2D_TILING_TABLE[now].C2D_FIRST;
        for (int turn = group; turn < (crowded && group > 0 ? 0 : C2D_LIVE[now]); turn += groups) {
            c2d_solve_other_tile(C2D_SOLVES[from + turn], crossing && !crowded, heap, status, world, bodies, places);
        }
    }
#else
    c2d_solve_other_tile(C2D_SOLVES[first + group], false, heap, status, world, bodies, places);
#endif
}

static float2 c2d_rescaled(float come, float last, float ratio) {
    return (float2)(come * ratio, last > 0.0f ? last * ratio : last);
}

// What impulses are worth in substeps of another time. One work-item a circle, going round where contacts are more.
__kernel void c2d_rescale(C2D_WORLD) {
    __global const float *rule = C2D_RULE;
    const float ratio = C2D_RESCALE;
    const int i = (int)get_global_id(0);
    const int contacts = C2D_LIST_START[world.circles];
    for (int k = i; k < contacts; k += (int)get_global_size(0)) {
        C2D_MEMORY[k] = c2d_rescaled(C2D_MEMORY[k].x, C2D_MEMORY[k].y, ratio);
    }
    if (i < world.circles) {
        for (int axis = 2 * i; axis < 2 * i + 2; axis++) {
            const float2 wall = C2D_WALLS[axis];
            C2D_WALLS[axis] = (float2)(wall.x * ratio, fabs(wall.y) < C2D_BOUNCED ? wall.y * ratio : wall.y);
        }
        C2D_BODY[i].s4 *= ratio;
        C2D_BODY[i].s5 *= ratio;
    }
}
