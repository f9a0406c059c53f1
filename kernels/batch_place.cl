// Of stage batch: puts a tile that batch_local.cl has coloured in the order of its colours, as batch_order.cl does, from local memory;
// and the kernel of both.

// The circles of the tile, `own` of `members`, get their turns in it in place of their masks, unless slots are turns.
static void c2d_batch_slots_to_turns(int2 own, __global const int *members, int slots, __local uint *masks,
                                     __local int *places) {
    for (int m = own.x + (int)get_local_id(0); m < own.y; m += (int)get_local_size(0)) {
        const int slot = c2d_batch_slot(members[m], slots, false, places);
        if (slot >= 0) {
            masks[slot] = (uint)(m - own.x);
        }
    }
}

// By one work-group, whose `bins` now count colours.
static void c2d_batch_place(int tile, int2 own, C2D_LOCAL, C2D_WORLD, __global int8 *solves) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const int first = C2D_TILE_START[C2D_PARTS * tile];
    const int end = C2D_TILE_START[C2D_PARTS * (tile + 1)];
    const bool fits = direct || c2d_fits(own);
    __global int *solved = C2D_BATCH + world.capacity;
    __local int *counts = bins;
    for (int c = item; c < C2D_LOCAL_COLOURS; c += items) {
        counts[c] = 0;
    }
    if (fits && !direct) {
        c2d_batch_slots_to_turns(own, C2D_MEMBERS, slots, masks, places);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int e = item; e < end - first; e += items) {
        atomic_inc(&counts[C2D_COLOUR(entries[e].x)]);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    if (item == 0) {
        int colours = 0;
        int start = first;
        for (; colours < C2D_LOCAL_COLOURS && counts[colours] > 0; colours++) {
            const int count = counts[colours];
            ((__global int *)(solves + 1))[colours] = start;
            counts[colours] = start;
            start += count;
        }
        *solves = (int8)(first, end, own.x, own.y, colours, fits, 1, 0);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int e = item; e < end - first; e += items) {
        const int2 entry = entries[e];
        const int i = C2D_SLOT_I(entry.x);
        const int j = C2D_SLOT_J(entry.x);
        const int to = atomic_inc(&counts[C2D_COLOUR(entry.x)]);
        if (direct) {
            solved[to] = i | j << C2D_TURN_BITS;
        } else if (fits) {
            solved[to] = (int)masks[i] | (int)masks[j] << C2D_TURN_BITS;
        } else {
            solved[to] = places[i];
            C2D_SECOND[to] = places[j];
        }
        C2D_MEMORY[to] = C2D_REMEMBERED[entry.y];
        C2D_WHERE[entry.y] = to;
    }
}

// One tile, in local memory if it fits; `solves` says whether it did. Otherwise it has colours after this, and is not in order yet.
static void c2d_batch_colour_tile(int tile, int2 own, bool clears, bool stalled, C2D_LOCAL, C2D_WORLD, __global int8 *solves) {
    const bool any = !stalled && C2D_TILE_START[C2D_PARTS * tile] < C2D_TILE_START[C2D_PARTS * (tile + 1)];
    const bool fitted = C2D_GPU && any && c2d_batch_colour_local(tile, C2D_BATCH_COLOUR_HERE, C2D_LOCAL_ALL);
    if (C2D_GPU && !fitted && get_local_id(0) == 0) {
        solves->s6 = 0;
    }
    if (fitted) {
        c2d_batch_place(tile, own, C2D_LOCAL_ALL, heap, status, world, solves);
    } else if (any) {
        c2d_batch_colour_any(tile, clears, C2D_BATCH_COLOUR_HERE, rows);
    }
}

// A tiling, one work-group a tile, on a GPU that has anything in it, going round where these are more.
__kernel void c2d_batch_colour(C2D_WORLD, int tiling, int tiles, int most, int slots, __local uint *masks,
                               __local int *places, __local int2 *entries, __local ushort *codes,
                               __local ushort *starts, __local int *bins, __local int *rows) {
    const bool direct = false;
    const bool stalled = status[C2D_STALLED] != 0u;
    const int firstTile = C2D_TILING_TABLE[tiling].C2D_FIRST;
    const int group = (int)get_group_id(0);
#if C2D_GPU
    for (int turn = group; turn < C2D_LIVE[tiling]; turn += (int)get_num_groups(0)) {
        const int place = firstTile + turn;
        const int tile = C2D_LIVE[C2D_TILINGS + place];
        const int2 own = tiling == 0 && !stalled ? c2d_members(tile, tiles, C2D_TILE_START) : (int2)(0, 0);
        c2d_batch_colour_tile(tile, own, tiling > 0, stalled, C2D_LOCAL_ALL, heap, status, world, C2D_SOLVES(place));
        barrier(CLK_LOCAL_MEM_FENCE);
    }
#else
    c2d_batch_colour_tile(firstTile + group, (int2)(0, 0), tiling > 0, stalled, C2D_LOCAL_ALL, heap, status, world,
                          C2D_SOLVES(firstTile + group));
#endif
}
