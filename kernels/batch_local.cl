// Of stage batch: colours a tile as batch_colour.cl does, in the local memory of a work-group, where that is worth its while and the
// tile fits. A contact of a bucket waits for the one before: here a few cycles, there a way to memory and back.

// What that takes: of up to `most` contacts the numbers, later the slots of their circles, the numbers in order, the classes, and which
// are first in their row; of up to `slots` circles, a power of two, the colours and, if slots are not places, whose they are; where parts
// begin; how many `rows` there are, or more than there can be where the tile does not fit.
#define C2D_LOCAL                                                                                                      \
    int most, int slots, bool direct, __local ulong *masks, __local int *places, __local int *keys, __local int *sorted, \
        __local ushort *classes, __local ushort *starts, __local int *bounds, __local int *rows
#define C2D_LOCAL_ALL most, slots, direct, masks, places, keys, sorted, classes, starts, bounds, rows

// Slots that are tried.
#define C2D_TRIES 32
// No tile has so many rows.
#define C2D_FAILS (1 << 30)

// The slot of a circle, or -1.
static int c2d_batch_slot(int place, int slots, bool direct, __local int *places) {
    if (direct) {
        return place < slots ? place : -1;
    }
    // by the golden ratio, so that neighbours do not meet
    uint slot = ((uint)place * 2654435769u) >> 16;
    for (int tries = 0; tries < C2D_TRIES; tries++, slot++) {
        const int at = (int)(slot & (uint)(slots - 1));
        const int was = atomic_cmpxchg(&places[at], -1, place);
        if (was == -1 || was == place) {
            return at;
        }
    }
    return -1;
}

// Puts the contacts of each part in the order of the lists; those of a bucket follow each other then.
static void c2d_batch_sort(int contacts, __local const int *keys, __local int *sorted, __local const int *bounds) {
    for (int e = (int)get_local_id(0); e < contacts; e += (int)get_local_size(0)) {
        int part = 0;
        while (bounds[part + 1] <= e) {
            part++;
        }
        const int k = keys[e];
        int to = bounds[part];
        for (int o = bounds[part]; o < bounds[part + 1]; o++) {
            to += keys[o] < k ? 1 : 0;
        }
        sorted[to] = k;
    }
}

// The contacts of a class that follow each other from e on. Those of several buckets share no circle.
static void c2d_batch_colour_row(int e, int contacts, C2D_LOCAL, __global ushort *tint) {
    const ushort class = classes[e];
    int last = -1;
    ulong own = 0ul;
    for (; e < contacts && classes[e] == class; e++) {
        const int i = keys[e] & 0xFFFF;
        const int j = keys[e] >> 16;
        if (i != last) {
            if (last >= 0) {
                masks[last] = own;
            }
            own = masks[i];
            last = i;
        }
        const ulong there = masks[j];
        const ulong free = ~(own | there);
        const ulong lowest = free & (0ul - free);
        if (free == 0ul) {
            *rows = C2D_FAILS;
        }
        own |= lowest;
        masks[j] = there | lowest;
        tint[sorted[e]] = (ushort)(C2D_COLOURS - 1 - (int)clz(lowest));
    }
    masks[last] = own;
}

// Whether it did: a tile may have too many contacts, circles or colours. By one work-group.
static bool c2d_batch_colour_local(int tile, C2D_BATCH_COLOUR, C2D_LOCAL) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const int first = tileStart[C2D_PARTS * tile];
    const int count = tileStart[C2D_PARTS * (tile + 1)] - first;
    if (count > most) {
        return false;
    }
    for (int e = item; e < count; e += items) {
        keys[e] = byTile[first + e];
    }
    for (int part = item; part <= C2D_PARTS; part += items) {
        bounds[part] = tileStart[C2D_PARTS * tile + part] - first;
    }
    for (int slot = item; slot < slots; slot += items) {
        masks[slot] = 0ul;
        if (!direct) {
            places[slot] = -1;
        }
    }
    if (item == 0) {
        *rows = 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    c2d_batch_sort(count, keys, sorted, bounds);
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int e = item; e < count; e += items) {
        const int k = sorted[e];
        const int i = c2d_batch_slot(batch[k], slots, direct, places);
        const int j = c2d_batch_slot(other[k], slots, direct, places);
        const int class = batch[capacity + k];
        keys[e] = i | j << 16;
        classes[e] = (ushort)class;
        if (i < 0 || j < 0) {
            atomic_max(rows, C2D_FAILS);
        } else if (e == 0 || batch[capacity + sorted[e - 1]] != class) {
            starts[atomic_inc(rows) & 0xFFFF] = (ushort)e;
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    const int all = *rows < C2D_FAILS ? *rows : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int class = 0; class < (all > 0 ? c2d_batch_classes(levelCount) : 0); class++) {
        for (int row = item; row < all; row += items) {
            if (classes[starts[row]] == class) {
                c2d_batch_colour_row(starts[row], count, C2D_LOCAL_ALL, tint);
            }
        }
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    const bool done = *rows < C2D_FAILS;
    barrier(CLK_LOCAL_MEM_FENCE);
    return done;
}

// One tile, where there are contacts in it.
static void c2d_batch_colour_tile(int tile, bool clears, bool stalled, C2D_BATCH_COLOUR, C2D_LOCAL) {
    const bool any = !stalled && tileStart[C2D_PARTS * tile] < tileStart[C2D_PARTS * (tile + 1)];
    if (any && !(C2D_GPU && c2d_batch_colour_local(tile, C2D_BATCH_COLOUR_ALL, C2D_LOCAL_ALL))) {
        c2d_batch_colour_any(tile, clears, C2D_BATCH_COLOUR_ALL, rows);
    }
}

// A tiling, one work-group a tile.
__kernel void c2d_batch_colour(C2D_WORLD, int firstTile, int most, int slots, __local ulong *masks, __local int *places,
                               __local int *keys, __local int *sorted, __local ushort *classes, __local ushort *starts,
                               __local int *bounds, __local int *rows) {
    const int tile = firstTile + (int)get_group_id(0);
    const bool direct = false;
    c2d_batch_colour_tile(tile, firstTile > 0, status[C2D_STALLED] != 0u, C2D_BATCH_COLOUR_HERE, C2D_LOCAL_ALL);
}
