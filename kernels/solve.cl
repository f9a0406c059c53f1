// The substeps: the circles' own share, integrate.cl, then one pass over the contacts, whose rule is in visit.cl.
// Solver.SMALL_STEPS. Twin of host.Solve.

#define C2D_SOLVE                                                                                                      \
    __global float8 *body, C2D_CIRCLES, __global float2 *memory, __global const int *second, int capacity,               \
        __global const int *batch
#define C2D_SOLVE_HERE C2D_BODY, C2D_CIRCLES_HERE, C2D_MEMORY, C2D_SECOND, world.capacity, C2D_BATCH

// The contacts of a tile, from `first` to `end`, a colour at a time, by one work-group. On a GPU, a work-item reads which its next
// contact is, and what is remembered of it, before it solves this one: nobody else changes that.
static void c2d_solve_tile(int first, int end, int colours, C2D_SOLVE) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    __global const int *solved = batch + capacity;
    __global const int *colourStart = batch + 2 * capacity + first;
    int2 nextPair = (int2)(0, 0);
    float2 nextMemory = (float2)(0.0f, 0.0f);
    if (C2D_GPU && colours > 0 && first + item < end) {
        nextPair = (int2)(solved[first + item], second[first + item]);
        nextMemory = memory[first + item];
    }
    int stop = colours > 1 ? colourStart[1] : end;
    for (int colour = 0, from = first; colour < colours; colour++) {
        const int nextStop = colour + 2 < colours ? colourStart[colour + 2] : end;
        for (; from < stop; from += items) {
            const int e = from + item;
            const bool own = e < stop;
            const int2 pair = C2D_GPU || !own ? nextPair : (int2)(solved[e], second[e]);
            float2 remembered = C2D_GPU || !own ? nextMemory : memory[e];
            const int next = min(from + items, stop) + item;
            if (C2D_GPU && next < nextStop) {
                nextPair = (int2)(solved[next], second[next]);
                nextMemory = memory[next];
            }
            if (own) {
                float8 a = body[pair.x];
                float8 b = body[pair.y];
                if (c2d_visit(&a, &b, &remembered, pair.x, pair.y, id, kicked, numbers)) {
                    body[pair.x] = a;
                    body[pair.y] = b;
                    memory[e] = remembered;
                }
            }
        }
        from = stop;
        stop = nextStop;
        barrier(CLK_GLOBAL_MEM_FENCE);
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

// What a tiling `begins` with, before its contacts: nothing; the start of a substep; the end of one and the start of the next; the start
// of a step that goes on with contacts that one before has listed.
#define C2D_NOTHING 0
#define C2D_KICK 1
#define C2D_MOVE_AND_KICK 2
#define C2D_KICK_ON 3

// A tile: the circles' own share, then its contacts. Where bodies fit into local memory they are read and written once, whatever
// the colours are.
static void c2d_solve_any(int8 tile, int begins, C2D_WORLD, __local float8 *bodies, __local int *places) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const bool stalled = status[C2D_STALLED] != 0u;
    const int circles = begins == C2D_NOTHING || stalled ? 0 : tile.s3 - tile.s2;
    const int colours = stalled ? 0 : tile.s4;
    const bool fits = begins != C2D_NOTHING && tile.s5 != 0;
    for (int m = item; m < circles; m += items) {
        const int place = C2D_MEMBERS[tile.s2 + m];
        const float8 body = c2d_integrated(C2D_BODY[place], place, begins == C2D_MOVE_AND_KICK, true, C2D_CIRCLES_HERE);
        if (fits) {
            c2d_body_to(bodies, m, C2D_TILE_CIRCLES, body);
            places[m] = place;
        } else {
            C2D_BODY[place] = body;
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    if (!fits) {
        c2d_solve_tile(tile.s0, tile.s1, colours, C2D_SOLVE_HERE);
        return;
    }
    c2d_solve_bodies(tile.s0, tile.s1, colours, bodies, C2D_TILE_CIRCLES, places, C2D_SOLVE_HERE);
    for (int m = item; m < circles; m += items) {
        C2D_BODY[places[m]] = c2d_body_of(bodies, m, C2D_TILE_CIRCLES);
    }
}

// A tiling, work-groups as for batch_local.cl. The first one begins with the circles' own share. On a GPU its tiles come `backwards` in
// every other substep: what was touched last is still in the cache then.
__kernel void c2d_solve(C2D_WORLD, int tiling, int firstTile, int begins, int backwards, __local float8 *bodies,
                        __local int *places) {
    const int group = (int)get_group_id(0);
    if (begins == C2D_KICK || begins == C2D_KICK_ON) {
        c2d_publish_clear(status, begins == C2D_KICK_ON);
    }
#if C2D_GPU
    const int tiles = C2D_LIVE[tiling];
    for (int turn = group; turn < tiles; turn += (int)get_num_groups(0)) {
        const int tile = firstTile + (backwards ? tiles - 1 - turn : turn);
        c2d_solve_any(*C2D_SOLVES(tile), begins, heap, status, world, bodies, places);
        barrier(CLK_LOCAL_MEM_FENCE);
    }
#else
    c2d_solve_any(*C2D_SOLVES(firstTile + group), begins, heap, status, world, bodies, places);
#endif
}

static float2 c2d_rescaled(float come, float last, float ratio) {
    return (float2)(come * ratio, last > 0.0f ? last * ratio : last);
}

// What impulses are worth in substeps of another time. One work-item a circle, going round where contacts are more.
__kernel void c2d_rescale(C2D_WORLD) {
    const float ratio = world.numbers.rescale;
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
