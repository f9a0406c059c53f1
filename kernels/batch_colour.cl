// Of stage batch: gives each contact its colour within its tile. Twin of host.Batch.
//
// Contacts are coloured in the order of their buckets: of one level after the other, and of each those whose column modulo 3
// and row modulo 2 (3 at wider levels) agree at a time, for these share no circle; each bucket's in the order of its lists.
// A contact gets the lowest colour that neither of its circles has yet. Neighbours in the order are neighbours in the pile,
// which carries loads farther in a pass than an order by chance does.

// Colours of which a circle has a mask: half of them for the first tiling, half for the others. Whoever finds none of them
// free gets one beyond all that its circles have beyond those, `beyond`.
#define C2D_COLOURS 64
#define C2D_FIRST_COLOURS 0xFFFFFFFFul
// What `tint` can hold.
#define C2D_COLOUR_MOST 65535

#define C2D_BATCH_COLOUR                                                                                               \
    __global const int *listStart, __global const int *other, __global const int *bucketStart,                           \
        __global const int8 *levels, __global uint *status, int capacity, __global int *batch,                           \
        __global ulong *mask, __global int *beyond, __global ushort *tint, int others
#define C2D_BATCH_COLOUR_ALL                                                                                           \
    listStart, other, bucketStart, levels, status, capacity, batch, mask, beyond, tint, others
#define C2D_BATCH_COLOUR_HERE                                                                                          \
    C2D_LIST_START, C2D_OTHER, C2D_BUCKET_START, C2D_LEVEL_TABLE, status, world.capacity, C2D_BATCH, C2D_MASK, C2D_BEYOND,  \
        C2D_TINT, others
#define C2D_BEYOND C2D_AT(int, from)

// Contacts that are read ahead.
#define C2D_AHEAD 4

static void c2d_batch_colour_list(int i, int k, int end, C2D_BATCH_COLOUR) {
    ulong own = mask[i];
    for (; k < end; k += C2D_AHEAD) {
        // the circles of a list are different ones, so that their masks can be read ahead
        int j[C2D_AHEAD];
        ulong there[C2D_AHEAD];
        ulong usable[C2D_AHEAD];
        for (int c = 0; c < C2D_AHEAD; c++) {
            const int at = min(k + c, end - 1);
            j[c] = other[at];
            there[c] = mask[j[c]];
            usable[c] = batch[2 * capacity + at] < others ? C2D_FIRST_COLOURS : ~C2D_FIRST_COLOURS;
        }
        for (int c = 0; c < C2D_AHEAD; c++) {
            if (k + c < end) {
                const ulong free = ~(own | there[c]) & usable[c];
                const ulong lowest = free & (0ul - free);
                int colour = C2D_COLOURS - 1 - (int)clz(lowest);
                if (free != 0ul) {
                    own |= lowest;
                    mask[j[c]] = there[c] | lowest;
                } else {
                    const int next = max(beyond[i], beyond[j[c]]) + 1;
                    beyond[i] = next;
                    beyond[j[c]] = next;
                    colour = C2D_COLOURS - 1 + next;
                    if (colour > C2D_COLOUR_MOST) {
                        status[C2D_STALLED] = C2D_TOO_DENSE;
                    }
                }
                tint[k + c] = (ushort)colour;
            }
        }
    }
    mask[i] = own;
}

// Bucket `item` of one colour of a level, of those `rows` rows apart whose column and row leave `x` and `y`. `across`: how many
// there are in a row.
static void c2d_batch_colour_bucket(int item, int8 level, int x, int y, int rows, int across, C2D_BATCH_COLOUR) {
    const int bucket = level.C2D_BASE + (y + rows * (item / across)) * level.C2D_WIDTH + x + 3 * (item % across);
    const int last = bucketStart[bucket + 1];
    int i = bucketStart[bucket];
    int start = listStart[i];
    for (; start < listStart[last]; i++) {
        const int end = listStart[i + 1];
        if (start < end) {
            c2d_batch_colour_list(i, start, end, C2D_BATCH_COLOUR_ALL);
        }
        start = end;
    }
}

// One work-item a bucket. `others`: first part of the tiles of the second tiling.
__kernel void c2d_batch_colour(C2D_WORLD, int others, int number, int x, int y, int rows, int across, int buckets) {
    const int item = (int)get_global_id(0);
    if (item < buckets && status[C2D_STALLED] == 0u) {
        c2d_batch_colour_bucket(item, C2D_LEVEL_TABLE[1 + number], x, y, rows, across, C2D_BATCH_COLOUR_HERE);
    }
}

// The levels from `firstLevel` on, all of their colours, by one work-group: where buckets are few, launches would cost more
// than the work.
static void c2d_batch_colour_levels(C2D_BATCH_COLOUR, int firstLevel, int levelCount, bool stalled) {
    for (int number = firstLevel; number < levelCount; number++) {
        const int8 level = levels[1 + number];
        const int rows = number == 0 ? 2 : 3;
        for (int colour = 0; colour < 3 * rows; colour++) {
            const int x = colour % 3;
            const int y = colour / 3;
            const int across = (level.C2D_WIDTH - x + 2) / 3;
            const int buckets = stalled ? 0 : across * ((level.C2D_HEIGHT - y + rows - 1) / rows);
            for (int item = (int)get_local_id(0); item < buckets; item += (int)get_local_size(0)) {
                c2d_batch_colour_bucket(item, level, x, y, rows, across, C2D_BATCH_COLOUR_ALL);
            }
            barrier(CLK_GLOBAL_MEM_FENCE);
        }
    }
}

__kernel void c2d_batch_colour_few(C2D_WORLD, int others, int firstLevel, int levelCount) {
    c2d_batch_colour_levels(C2D_BATCH_COLOUR_HERE, firstLevel, levelCount, status[C2D_STALLED] != 0u);
}
