// Of stage batch: colours a tile as batch_colour.cl does, in the local memory of a work-group, where that is worth its while
// and the tile fits; batch_place.cl goes on from there. A contact of a bucket waits for the one before: here a few cycles, there
// a way to memory and back.

// What that takes: of up to `most` contacts, entries, the codes, and which are first in their row; of up to `slots` circles, the
// colours, up to C2D_LOCAL_COLOURS, and, unless they are `direct`, whose they are; where bins begin; how many `rows` there are, or
// more than there can be where the tile does not fit. An entry is, in the end, the slots of the two circles, with C2D_LAST in the
// last of a row, and the colour, and the number of the contact. `direct`, of a world that is one tile: slots are places, and its
// contacts, in the order of the lists, are in rows already. If not, slots are a power of two.
#define C2D_LOCAL                                                                                                      \
    int most, int slots, bool direct, __local uint *masks, __local int *places, __local int2 *entries,                  \
        __local ushort *codes, __local ushort *starts, __local int *bins, __local int *rows
#define C2D_LOCAL_ALL most, slots, direct, masks, places, entries, codes, starts, bins, rows
#define C2D_SLOT_BITS 12
#define C2D_LAST (1 << 24)
#define C2D_COLOUR_AT 25
#define C2D_SLOT_I(entry) ((entry) & ((1 << C2D_SLOT_BITS) - 1))
#define C2D_SLOT_J(entry) ((entry) >> C2D_SLOT_BITS & ((1 << C2D_SLOT_BITS) - 1))
#define C2D_COLOUR(entry) ((entry) >> C2D_COLOUR_AT)

// Rows that there is room for, unless slots are `direct`; and more than any tile has.
#define C2D_ROWS 256
#define C2D_FAILS (1 << 30)

// A row: the contacts from e on that have one code. If they are of several buckets, these share no circle. The colours of the next
// contact's circles are read before this one has its own, for one waits for the other.
static void c2d_batch_colour_row(int e, C2D_LOCAL) {
    int2 now = entries[e];
    uint own = masks[C2D_SLOT_I(now.x)];
    uint there = masks[C2D_SLOT_J(now.x)];
    bool last;
    do {
        last = (now.x & C2D_LAST) != 0;
        const int2 next = entries[last ? e : e + 1];
        const int i = C2D_SLOT_I(now.x);
        const int j = C2D_SLOT_J(now.x);
        const int nextI = C2D_SLOT_I(next.x);
        const int nextJ = C2D_SLOT_J(next.x);
        uint nextOwn = masks[nextI];
        uint nextThere = masks[nextJ];
        const uint free = ~(own | there);
        const uint lowest = free & (0u - free);
        if (free == 0u) {
            *rows = C2D_FAILS;
        }
        own |= lowest;
        there |= lowest;
        masks[j] = there;
        entries[e].x = now.x | (C2D_LOCAL_COLOURS - 1 - (int)clz(lowest)) << C2D_COLOUR_AT;
        nextThere = nextJ == j ? there : nextJ == i ? own : nextThere;
        nextOwn = nextI == i ? own : nextI == j ? there : nextOwn;
        if (nextI != i || last) {
            masks[i] = own;
        }
        own = nextOwn;
        there = nextThere;
        now = next;
        e++;
    } while (!last);
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
    for (int slot = item; slot < slots; slot += items) {
        masks[slot] = 0u;
        if (!direct) {
            places[slot] = -1;
        }
    }
    if (item == 0) {
        *rows = 0;
    }
    if (direct) {
        for (int e = item; e < count; e += items) {
            entries[e].y = byTile[first + e];
        }
    } else {
        c2d_batch_sort(count, byTile + first, code, entries, codes, bins);
    }
    for (int e = item; e < count; e += items) {
        codes[e] = code[entries[e].y];
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int e = item; e < count; e += items) {
        const int k = entries[e].y;
        const int i = c2d_batch_slot(batch[k], slots, direct, places);
        const int j = c2d_batch_slot(other[k], slots, direct, places);
        const bool last = e + 1 == count || codes[e + 1] != codes[e];
        entries[e].x = i | j << C2D_SLOT_BITS | (last ? C2D_LAST : 0);
        if (i < 0 || j < 0) {
            atomic_max(rows, C2D_FAILS);
        } else if (e == 0 || codes[e - 1] != codes[e]) {
            const int row = atomic_inc(rows);
            if (direct || row < C2D_ROWS) {
                starts[row] = (ushort)e;
            } else {
                atomic_max(rows, C2D_FAILS);
            }
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    const int all = *rows < C2D_FAILS ? *rows : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int class = 0; class < (all > 0 ? c2d_batch_classes(levelCount) : 0); class++) {
        for (int row = item; row < all; row += items) {
            if (C2D_CLASS(codes[starts[row]]) == class) {
                c2d_batch_colour_row(starts[row], C2D_LOCAL_ALL);
            }
        }
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    const bool done = *rows < C2D_FAILS;
    barrier(CLK_LOCAL_MEM_FENCE);
    return done;
}
