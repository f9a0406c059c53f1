// Of stage batch: gives each contact its colour within its tile. Twin of host.Batch. The kernel is in batch_local.cl.
//
// The contacts of a tile are coloured class by class, those of a bucket in the order of its lists: buckets of one class,
// batch.cl, share no circle. A contact gets the lowest colour that neither of its circles has yet in the tile. Neighbours in
// the order are neighbours in the pile, which carries loads farther in a pass than an order by chance does.

// Colours of which a circle has a mask. Whoever finds none of them free gets one beyond all that its circles have beyond
// those, `beyond`.
#define C2D_COLOURS 64
// The last there is; until a contact is in order, its place in the order is the complement of its colour.
#define C2D_COLOUR_MOST 65535

#define C2D_BATCH_COLOUR                                                                                               \
    __global const int *listStart, __global const int *other, int contacts, int levelCount, __global uint *status,       \
        int capacity, __global const int *batch, __global const int *byTile, __global const int *tileStart,              \
        __global int2 *heads, __global ulong *mask, __global int *beyond, __global const ushort *code, __global int *where
#define C2D_BATCH_COLOUR_ALL                                                                                           \
    listStart, other, contacts, levelCount, status, capacity, batch, byTile, tileStart, heads, mask, beyond, code, where
#define C2D_BATCH_COLOUR_HERE                                                                                          \
    C2D_LIST_START, C2D_OTHER, C2D_LIST_START[world.circles], C2D_LEVEL_TABLE[0].C2D_LEVELS, status, world.capacity,       \
        C2D_BATCH, C2D_BY_TILE, C2D_TILE_START, C2D_HEADS, C2D_MASK, C2D_BEYOND, C2D_CODE, C2D_WHERE
#define C2D_BEYOND C2D_AT(int, from)
// What is remembered is with the contacts, until they are in the order of solving.
#define C2D_HEADS C2D_AT(int2, memory)

static bool c2d_batch_holds(int tile, int k, int capacity, __global const int *batch) {
    return batch[2 * capacity + k] / C2D_PARTS == tile;
}

// Appends to `heads`, from the first contact of the tile on, in any order, the codes and first contacts of its runs: those that
// follow each other in the order of lists and have one code are of one bucket, or of several that share no circle. `clears` what
// circles know of colours; for the first tiling that is done. By one work-group.
static void c2d_batch_heads(int tile, bool clears, C2D_BATCH_COLOUR, __local int *count) {
    const int first = tileStart[C2D_PARTS * tile];
    const int end = tileStart[C2D_PARTS * (tile + 1)];
    for (int e = first + (int)get_local_id(0); e < end; e += (int)get_local_size(0)) {
        const int k = byTile[e];
        if (clears) {
            const int i = batch[k];
            const int j = other[k];
            mask[i] = 0ul;
            mask[j] = 0ul;
            beyond[i] = 0;
            beyond[j] = 0;
        }
        const int own = code[k];
        int before = k - 1;
        while (before >= 0 && code[before] == own && !c2d_batch_holds(tile, before, capacity, batch)) {
            before--;
        }
        if (before < 0 || code[before] != own) {
            heads[first + atomic_inc(count)] = (int2)(own, k);
        }
    }
}

// Those of a tile in the list of circle i, from k on.
static void c2d_batch_colour_list(int i, int k, int end, int tile, C2D_BATCH_COLOUR) {
    ulong own = 0ul;
    bool used = false;
    for (; k < end; k++) {
        if (c2d_batch_holds(tile, k, capacity, batch)) {
            const int j = other[k];
            const ulong there = mask[j];
            own = used ? own : mask[i];
            used = true;
            const ulong free = ~(own | there);
            const ulong lowest = free & (0ul - free);
            int colour = C2D_COLOURS - 1 - (int)clz(lowest);
            if (free != 0ul) {
                own |= lowest;
                mask[j] = there | lowest;
            } else {
                const int next = max(beyond[i], beyond[j]) + 1;
                beyond[i] = next;
                beyond[j] = next;
                colour = C2D_COLOURS - 1 + next;
                if (colour > C2D_COLOUR_MOST) {
                    status[C2D_STALLED] = C2D_TOO_DENSE;
                }
            }
            where[k] = ~colour;
        }
    }
    if (used) {
        mask[i] = own;
    }
}

// Those of a tile in a run, from contact k on.
static void c2d_batch_colour_run(int k, int tile, C2D_BATCH_COLOUR) {
    const int own = code[k];
    for (int i = batch[k]; k < contacts && code[k] == own; i++) {
        const int next = listStart[i + 1];
        c2d_batch_colour_list(i, k, next, tile, C2D_BATCH_COLOUR_ALL);
        k = next;
    }
}

// Any tile that has contacts, by one work-group, a class after the other.
static void c2d_batch_colour_any(int tile, bool clears, C2D_BATCH_COLOUR, __local int *count) {
    const int first = tileStart[C2D_PARTS * tile];
    if (get_local_id(0) == 0) {
        *count = 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    c2d_batch_heads(tile, clears, C2D_BATCH_COLOUR_ALL, count);
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    const int runs = *count;
    for (int class = 0; class < c2d_batch_classes(levelCount); class++) {
        for (int h = (int)get_local_id(0); h < runs; h += (int)get_local_size(0)) {
            const int2 head = heads[first + h];
            if (C2D_CLASS(head.x) == class) {
                c2d_batch_colour_run(head.y, tile, C2D_BATCH_COLOUR_ALL);
            }
        }
        barrier(CLK_GLOBAL_MEM_FENCE);
    }
}
