// Puts the contacts in the order in which they are solved: pipeline.Tiles says which tile a contact belongs to, and within a
// tile contacts have colours, so that those of one colour share no circle. Twin of host.Batch.
//
// Contacts are coloured in the order of their buckets: of one level after the other, and of each those whose column modulo 3
// and row modulo 2 (3 at wider levels) agree at a time, for these share no circle; each bucket's in the order of its lists.
// A contact gets the lowest colour that neither of its circles has yet. Neighbours in the order are neighbours in the pile,
// which carries loads farther in a pass than an order by chance does.
//
// `batch` has three parts of `capacity` ints. By contact: its circle `owner`, in whose list it is; which of its part of its tile
// it was counted as; that part. Then, in the order of solving: `index`, the contact; and, from the first contact of a tile on,
// where its colours begin. `tileStart`: the first contact of each part of each tile.

#define C2D_SIDE s1
#define C2D_COLUMNS s2
#define C2D_ROWS s3
#define C2D_FIRST s4

static int c2d_tile(int2 cell, int8 tiling) {
    int column = (cell.x + tiling.s0) >> tiling.C2D_SIDE;
    int row = (cell.y + tiling.s0) >> tiling.C2D_SIDE;
    column = column < tiling.C2D_COLUMNS ? column : column % tiling.C2D_COLUMNS;
    row = row < tiling.C2D_ROWS ? row : row % tiling.C2D_ROWS;
    return tiling.C2D_FIRST + column * tiling.C2D_ROWS + row;
}

// The contacts of a tile, and its circles, are counted in so many parts, by rows of cells: counting into one place takes turns,
// and what is of one row lies together in memory.
#define C2D_PARTS 8

// Contact k, at one of the parts of its tile; or, where all tiles of a tiling are done as one, of its tiling.
static void c2d_batch_count_at(int k, bool asOne, __global const float8 *body, int8 all, __global const int8 *tilings,
                               __global const float *rule, __global const int *other, int capacity, __global int *batch,
                               __global int *tileStart) {
    const int2 a = c2d_finest_cell(body[batch[k]].s01, all, rule);
    const int2 b = c2d_finest_cell(body[other[k]].s01, all, rule);
    // the last tiling holds whatever those before do not
    int tiling = 0;
    int tile = c2d_tile(a, tilings[0]);
    while (tile != c2d_tile(b, tilings[tiling])) {
        tiling++;
        tile = c2d_tile(a, tilings[tiling]);
    }
    const int part = C2D_PARTS * (asOne ? tiling : tile) + a.y % C2D_PARTS;
    batch[capacity + k] = atomic_inc(&tileStart[part + 1]);
    batch[2 * capacity + k] = part;
}

// The part of the circle at place p: circles are counted after the contacts of all `tiles`, by tiles of the first tiling.
static int c2d_batch_part(int p, __global const float8 *body, int8 all, __global const int8 *tilings,
                          __global const float *rule, int tiles) {
    const int2 cell = c2d_finest_cell(body[p].s01, all, rule);
    return C2D_PARTS * (tiles + c2d_tile(cell, tilings[0])) + cell.y % C2D_PARTS;
}

// One work-item a contact, going round where they are more. Circles are counted where tiles are told which are theirs: `fused`.
__kernel void c2d_batch_count(__global const float8 *body, __global const int8 *levels, __global const int8 *tilings,
                              __global const float *rule, __global const uint *status, int circles,
                              __global const int *listStart, __global const int *other, int capacity, int tiles,
                              int fused, __global int *batch, __global int *tileStart, __global int *turn) {
    const int8 all = levels[0];
    const bool stalled = status[C2D_STALLED] != 0u;
    const int contacts = stalled ? 0 : listStart[circles];
    for (int k = (int)get_global_id(0); k < contacts; k += (int)get_global_size(0)) {
        c2d_batch_count_at(k, false, body, all, tilings, rule, other, capacity, batch, tileStart);
    }
    for (int p = (int)get_global_id(0); p < (stalled || !fused ? 0 : circles); p += (int)get_global_size(0)) {
        turn[p] = atomic_inc(&tileStart[c2d_batch_part(p, body, all, tilings, rule, tiles) + 1]);
    }
}

static void c2d_batch_fill_at(int k, int capacity, __global const int *batch, __global const int *tileStart,
                              __global int *byTile) {
    byTile[tileStart[batch[2 * capacity + k]] + batch[capacity + k]] = k;
}

__kernel void c2d_batch_fill(__global const float8 *body, __global const int8 *levels, __global const int8 *tilings,
                             __global const float *rule, __global const uint *status, int circles,
                             __global const int *listStart, int capacity, int tiles, int fused,
                             __global const int *batch, __global const int *tileStart, __global int *turn,
                             __global int *byTile, __global int *members, __global ulong *mask) {
    const int8 all = levels[0];
    const bool stalled = status[C2D_STALLED] != 0u;
    const int contacts = stalled ? 0 : listStart[circles];
    for (int k = (int)get_global_id(0); k < contacts; k += (int)get_global_size(0)) {
        c2d_batch_fill_at(k, capacity, batch, tileStart, byTile);
    }
    for (int p = (int)get_global_id(0); p < (stalled ? 0 : circles); p += (int)get_global_size(0)) {
        if (fused) {
            members[tileStart[c2d_batch_part(p, body, all, tilings, rule, tiles)] - contacts + turn[p]] = p;
        }
        turn[p] = 0;
        mask[p] = 0ul;
    }
}

// Colours of which a circle has a mask: half of them for the first tiling, half for the others. Whoever finds none of them
// free gets one beyond all that its circles have beyond those, `beyond`.
#define C2D_COLOURS 64
#define C2D_FIRST_COLOURS 0xFFFFFFFFul
// What `tint` can hold.
#define C2D_COLOUR_MOST 65535

#define C2D_BATCH_COLOUR                                                                                               \
    __global const int *listStart, __global const int *other, __global const int *bucketStart,                           \
        __global const int8 *levels, __global uint *status, int capacity, __global const int *batch,                     \
        __global ulong *mask, __global int *beyond, __global ushort *tint, int others
#define C2D_BATCH_COLOUR_HERE                                                                                          \
    listStart, other, bucketStart, levels, status, capacity, batch, mask, beyond, tint, others

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
            c2d_batch_colour_list(i, start, end, C2D_BATCH_COLOUR_HERE);
        }
        start = end;
    }
}

// One work-item a bucket. `others`: first part of the tiles of the second tiling.
__kernel void c2d_batch_colour(C2D_BATCH_COLOUR, int number, int x, int y, int rows, int across, int buckets) {
    const int item = (int)get_global_id(0);
    if (item < buckets && status[C2D_STALLED] == 0u) {
        c2d_batch_colour_bucket(item, levels[1 + number], x, y, rows, across, C2D_BATCH_COLOUR_HERE);
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
                c2d_batch_colour_bucket(item, level, x, y, rows, across, C2D_BATCH_COLOUR_HERE);
            }
            barrier(CLK_GLOBAL_MEM_FENCE);
        }
    }
}

__kernel void c2d_batch_colour_few(C2D_BATCH_COLOUR, int firstLevel, int levelCount) {
    c2d_batch_colour_levels(C2D_BATCH_COLOUR_HERE, firstLevel, levelCount, status[C2D_STALLED] != 0u);
}

// The circles of a tile of the first tiling, from .x to .y of `members`.
static int2 c2d_members(int tile, int tiles, __global const int *tileStart) {
    const int contacts = tileStart[C2D_PARTS * tiles];
    return (int2)(tileStart[C2D_PARTS * (tiles + tile)] - contacts, tileStart[C2D_PARTS * (tiles + tile + 1)] - contacts);
}

// Whether a tile fits into the local memory of a work-group. Its `pairs` are then the turns of two circles in the tile, in one
// int, and the turn of the contact in `byTile`.
#define C2D_TURN_BITS 15
static bool c2d_fits(int circles, int contacts) {
    return circles <= C2D_TILE_CIRCLES && contacts <= C2D_TILE_CONTACTS;
}

// A tile's contacts by colour, to `pairs` and to the second part of `batch`, by one work-group. `counts`: of so many colours,
// then how many contacts are in order, then the lowest colour that comes later.
static void c2d_batch_order_tile(int tile, __global const int *other, __global const int *byTile,
                                 __global const ushort *tint, int capacity, __global int *batch, __global int2 *pairs,
                                 __global const int *tileStart, __global int *tileColours, bool stalled, int2 own,
                                 __global const int *members, __global int *turn, __local int *counts) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const int first = tileStart[C2D_PARTS * tile];
    const int end = stalled ? first : tileStart[C2D_PARTS * (tile + 1)];
    __global int *colourStart = batch + 2 * capacity + first;
    __local int *sorted = counts + C2D_COLOURS;
    __local int *later = sorted + 1;
    const bool fits = own.x < own.y && c2d_fits(own.y - own.x, end - first);
    for (int m = own.x + item; m < (fits ? own.y : 0); m += items) {
        turn[members[m]] = m - own.x;
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
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
            const int colour = (int)tint[byTile[e]] - lowest;
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
            const int colour = (int)tint[k] - lowest;
            if (colour >= 0 && colour < C2D_COLOURS) {
                const int to = atomic_inc(&counts[colour]);
                const int i = batch[k];
                const int j = other[k];
                pairs[to] = fits ? (int2)(turn[i] | turn[j] << C2D_TURN_BITS, e - first) : (int2)(i, j);
                batch[capacity + to] = k;
            }
        }
        done = *sorted;
        lowest = *later;
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    if (item == 0) {
        tileColours[tile] = colours;
    }
}

// One work-group a tile.
__kernel void c2d_batch_order(__global const int *other, __global const int *byTile, __global const ushort *tint,
                              int capacity, __global int *batch, __global int2 *pairs, __global const int *tileStart,
                              __global int *tileColours, __global const uint *status, int firstTiles, int tiles, int fused,
                              __global const int *members, __global int *turn, __local int *counts) {
    const int tile = (int)get_group_id(0);
    const bool stalled = status[C2D_STALLED] != 0u;
    const int2 own = fused && !stalled && tile < firstTiles ? c2d_members(tile, tiles, tileStart) : (int2)(0, 0);
    c2d_batch_order_tile(tile, other, byTile, tint, capacity, batch, pairs, tileStart, tileColours, stalled, own, members,
                         turn, counts);
}
