// Of stage batch: puts the contacts of each tile in the order of their colours, in which they are solved. Twin of host.Batch.
// batch_place.cl does so for tiles that are coloured in local memory.

// Whether a tile fits into the local memory of a work-group. Its `solved` are then the turns of two circles in the tile, in one
// int; else they are the places of the circles in whose lists the contacts are, and `second`, which takes the place of `byTile`, has
// those of the other ones.
#define C2D_SECOND C2D_BY_TILE
#define C2D_TURN_BITS 15
#define C2D_REMEMBERED C2D_AT(const float2, found)

// What solve.cl needs of a tile: its contacts, from .s0 to .s1 of `solved`, in .s4 colours; its circles, from .s2 to .s3 of `members`;
// whether it fits, .s5; whether batch_place.cl has put it in order, .s6. Where its colours begin follows then, of up to
// C2D_LOCAL_COLOURS, until `batch` has room for that. By tile, or by place in `live`. Twin: opencl.Heap.
#define C2D_LOCAL_COLOURS 32
#define C2D_SOLVES(place) (C2D_AT(int8, solves) + (1 + C2D_LOCAL_COLOURS / 8) * (place))
static bool c2d_fits(int2 own) { return own.x < own.y && own.y - own.x <= C2D_TILE_CIRCLES; }

// A tile's contacts by colour, with what is `remembered` of them, by one work-group. `counts`: of so many colours, then how many
// contacts are in order, then the lowest colour that comes later. `turn`: that of each circle in a tile that `fits`, or null where
// it is the place. Of a tile that is `placed` already, nothing: by its loops, for PoCL 3.1 loses work-items where a barrier is in a
// condition on what memory says.
static void c2d_batch_order_tile(int tile, __global const int *other, __global int *byTile, int capacity,
                                 __global int *batch,
                                 __global const float2 *remembered, __global float2 *memory, __global int *where,
                                 __global const int *tileStart, __global int8 *solves, int2 own, bool stalled, bool placed, bool fits,
                                 __global const int *turn, __local int *counts) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const int first = tileStart[C2D_PARTS * tile];
    const int end = stalled || placed ? first : tileStart[C2D_PARTS * (tile + 1)];
    __global int *solved = batch + capacity;
    __global int *colourStart = batch + 2 * capacity + first;
    __local int *sorted = counts + C2D_COLOURS;
    __local int *later = sorted + 1;
    int done = first;
    int lowest = 0;
    int colours = 0;
    while (done < end) {
        for (int c = item; c < C2D_COLOURS; c += items) {
            counts[c] = 0;
        }
        if (item == 0) {
            *later = C2D_COLOUR_MOST;
        }
        barrier(CLK_LOCAL_MEM_FENCE);
        for (int e = first + item; e < end; e += items) {
            const int colour = ~where[byTile[e]] - lowest;
            if (colour >= C2D_COLOURS) {
                atomic_min(later, colour + lowest);
            } else if (colour >= 0) {
                atomic_inc(&counts[colour]);
            }
        }
        barrier(CLK_LOCAL_MEM_FENCE);
        if (item == 0) {
            int start = done;
            for (int c = 0; c < C2D_COLOURS; c++) {
                const int own = counts[c];
                counts[c] = start;
                if (own > 0) {
                    colourStart[colours++] = start;
                }
                start += own;
            }
            *sorted = start;
        }
        barrier(CLK_LOCAL_MEM_FENCE);
        for (int e = first + item; e < end; e += items) {
            const int k = byTile[e];
            const int colour = ~where[k] - lowest;
            if (colour >= 0 && colour < C2D_COLOURS) {
                const int to = atomic_inc(&counts[colour]);
                int pair = k;
                if (fits) {
                    const int i = batch[k];
                    const int j = other[k];
                    pair = turn == 0 ? i | j << C2D_TURN_BITS : turn[i] | turn[j] << C2D_TURN_BITS;
                }
                solved[to] = pair;
                memory[to] = remembered[k];
                where[k] = to;
            }
        }
        done = *sorted;
        lowest = *later;
        barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    }
    // only now does nobody need `byTile` any longer
    for (int e = first + item; e < (fits ? first : end); e += items) {
        const int k = solved[e];
        solved[e] = batch[k];
        byTile[e] = other[k];
    }
    if (item == 0 && !placed) {
        *solves = (int8)(first, end, own.x, own.y, colours, fits, 0, 0);
    }
}

// Whether batch_place.cl has put a tile in order. If so, what is left to do is done.
static bool c2d_batch_placed(__global const int8 *solves, bool stalled, int capacity, __global int *batch) {
    const bool placed = C2D_GPU && !stalled && solves->s6 != 0;
    for (int c = (int)get_local_id(0); placed && c < solves->s4; c += (int)get_local_size(0)) {
        batch[2 * capacity + solves->s0 + c] = ((__global const int *)(solves + 1))[c];
    }
    return placed;
}

// Where in `live` the tile is that comes at a turn, of all tilings, or -1.
static int c2d_live_place(int turn, int tilings, __global const int8 *table, __global const int *live) {
    for (int tiling = 0; tiling < tilings; tiling++) {
        if (turn < live[tiling]) {
            return table[tiling].C2D_FIRST + turn;
        }
        turn -= live[tiling];
    }
    return -1;
}

// What the host sizes the launches of the next step by: how many tiles of one tiling have anything in them.
static uint c2d_live_most(int tilings, __global const int *live) {
    int most = 0;
    for (int tiling = 0; tiling < tilings; tiling++) {
        most = max(most, live[tiling]);
    }
    return (uint)most;
}

static void c2d_batch_order_any(int tile, int place, int tiles, C2D_WORLD, __local int *counts) {
    const bool stalled = status[C2D_STALLED] != 0u;
    const bool placed = c2d_batch_placed(C2D_SOLVES(place), stalled, world.capacity, C2D_BATCH);
    const bool isFirst = !stalled && !placed && tile < C2D_TILING_TABLE[1].C2D_FIRST;
    const int2 own = isFirst ? c2d_members(tile, tiles, C2D_TILE_START) : (int2)(0, 0);
    const bool fits = c2d_fits(own);
    for (int m = own.x + (int)get_local_id(0); m < (fits ? own.y : 0); m += (int)get_local_size(0)) {
        C2D_TURN_OF[C2D_MEMBERS[m]] = m - own.x;
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    c2d_batch_order_tile(tile, C2D_OTHER, C2D_BY_TILE, world.capacity, C2D_BATCH, C2D_REMEMBERED, C2D_MEMORY,
                         C2D_WHERE, C2D_TILE_START, C2D_SOLVES(place), own, stalled, placed, fits, C2D_TURN_OF, counts);
}

// All tilings, work-groups as for batch_local.cl.
__kernel void c2d_batch_order(C2D_WORLD, int tiles, int tilings, __local int *counts) {
    const int group = (int)get_group_id(0);
#if C2D_GPU
    if (get_global_id(0) == 0 && status[C2D_STALLED] == 0u) {
        status[C2D_TILES] = c2d_live_most(tilings, C2D_LIVE);
    }
    int turn = group;
    for (int place = c2d_live_place(turn, tilings, C2D_TILING_TABLE, C2D_LIVE); place >= 0;
         place = c2d_live_place(turn, tilings, C2D_TILING_TABLE, C2D_LIVE)) {
        c2d_batch_order_any(C2D_LIVE[C2D_TILINGS + place], place, tiles, heap, status, world, counts);
        turn += (int)get_num_groups(0);
    }
#else
    c2d_batch_order_any(group, group, tiles, heap, status, world, counts);
#endif
}
