// Puts the contacts in the order in which they are solved: pipeline.Tiles says which tile a contact belongs to, and within a
// tile contacts get colours, so that contacts of one colour share no circle. Twin of host.Batch.
//
// In the order of a pseudo-random number, each contact gets the lowest colour that neither of its circles has yet. In
// parallel: one that comes first at both of its circles may take its turn, since those it shares circles with come later or
// have theirs (Jones and Plassmann, 1993).
//
// `batch` has three parts of `capacity` ints. By contact: its circle `owner`, in whose list it is; which of its tile it was
// counted as; the part of its tile. Then, in the order of solving: `index`, the contact; and, from the first contact of a tile on, where its
// colours begin. `tileStart`: the first contact of each part of each tile.

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

static int2 c2d_finest_cell(float2 centre, int8 all, __global const float *rule) {
    const float perUnit = as_float(all.C2D_PER_UNIT);
    return (int2)(c2d_finest(centre.x, C2D_MIN(0), perUnit, all.C2D_LAST_X),
                  c2d_finest(centre.y, C2D_MIN(1), perUnit, all.C2D_LAST_Y));
}

// In `owner`: the line between the centres stands rather than lies.
#define C2D_STANDS INT_MIN

// Colours of which a circle has a mask; contacts that find none of them free get later ones, as many at a time.
#define C2D_COLOURS 32
// What `tint` says of a contact without such a colour: it waits for one; it is in order; it takes part.
#define C2D_WAITS 32
#define C2D_DONE 33
#define C2D_OPEN 34

// The contacts of a tile, and its circles, are counted in so many parts: counting into one place takes turns.
#define C2D_PARTS 8

// Circles, whose tile is that of the first tiling, are counted after the contacts of all `tiles`. One work-item a contact, going
// round where they are more.
__kernel void c2d_batch_count(__global const float8 *body, __global const int8 *levels, __global const int8 *tilings,
                              __global const float *rule, __global const uint *status, int circles,
                              __global const int *listStart, __global const int *other, int capacity, int tiles,
                              __global int *batch, __global int *tileStart, __global int *turn) {
    const int8 all = levels[0];
    const bool stalled = status[C2D_STALLED] != 0u;
    const int contacts = stalled ? 0 : listStart[circles];
    for (int k = (int)get_global_id(0); k < contacts; k += (int)get_global_size(0)) {
        const int i = batch[k];
        const float2 centreA = body[i].s01;
        const float2 centreB = body[other[k]].s01;
        const int2 a = c2d_finest_cell(centreA, all, rule);
        const int2 b = c2d_finest_cell(centreB, all, rule);
        // the last tiling holds whatever those before do not
        int tiling = 0;
        int tile = c2d_tile(a, tilings[0]);
        while (tile != c2d_tile(b, tilings[tiling])) {
            tiling++;
            tile = c2d_tile(a, tilings[tiling]);
        }
        const int part = C2D_PARTS * tile + k % C2D_PARTS;
        batch[capacity + k] = atomic_inc(&tileStart[part + 1]);
        batch[2 * capacity + k] = part;
        batch[k] = fabs(centreA.y - centreB.y) >= fabs(centreA.x - centreB.x) ? i | C2D_STANDS : i;
    }
    for (int p = (int)get_global_id(0); p < (stalled ? 0 : circles); p += (int)get_global_size(0)) {
        const int tile = c2d_tile(c2d_finest_cell(body[p].s01, all, rule), tilings[0]);
        turn[circles + p] = atomic_inc(&tileStart[C2D_PARTS * (tiles + tile) + p % C2D_PARTS + 1]);
    }
}

__kernel void c2d_batch_fill(__global const float8 *body, __global const int8 *levels, __global const int8 *tilings,
                             __global const float *rule, __global const uint *status, int circles,
                             __global const int *listStart, int capacity, int tiles,
                             __global const int *batch, __global const int *tileStart, __global const int *turn,
                             __global int *byTile, __global uchar *tint, __global int *members) {
    const bool stalled = status[C2D_STALLED] != 0u;
    const int contacts = stalled ? 0 : listStart[circles];
    for (int k = (int)get_global_id(0); k < contacts; k += (int)get_global_size(0)) {
        byTile[tileStart[batch[2 * capacity + k]] + batch[capacity + k]] = k;
        tint[k] = C2D_WAITS;
    }
    for (int p = (int)get_global_id(0); p < (stalled ? 0 : circles); p += (int)get_global_size(0)) {
        const int tile = c2d_tile(c2d_finest_cell(body[p].s01, levels[0], rule), tilings[0]);
        members[tileStart[C2D_PARTS * (tiles + tile) + p % C2D_PARTS] - contacts + turn[circles + p]] = p;
    }
}

// What comes first: contacts that lie, then those that stand, each in an order that looks like chance; no two are equal.
static uint c2d_priority(int contact, int owner) {
    return (((uint)contact * 0x9E3779B1u) & INT_MAX) | ((uint)owner & C2D_STANDS);
}

// The lowest colour that neither of two circles has yet, or C2D_WAITS.
static int c2d_colour(int i, int j, __global uint *mask) {
    const uint free = ~(mask[i] | mask[j]);
    const uint lowest = free & (0u - free);
    mask[i] |= lowest;
    mask[j] |= lowest;
    return free == 0u ? C2D_WAITS : 31 - (int)clz(lowest);
}

#if C2D_ALONE
// A group of one work-item has an order to go by: sorts by the highest byte of the priority, and then within it. `room` for as
// many contacts.
static void c2d_batch_sort(int first, int end, __global int *byTile, __global const int *batch,
                           __global int *room) {
    int start[256];
    for (int byte = 0; byte < 256; byte++) {
        start[byte] = 0;
    }
    for (int e = first; e < end; e++) {
        start[c2d_priority(byTile[e], batch[byTile[e]]) >> 24]++;
    }
    int sum = first;
    for (int byte = 0; byte < 256; byte++) {
        const int own = start[byte];
        start[byte] = sum;
        sum += own;
    }
    for (int e = first; e < end; e++) {
        room[start[c2d_priority(byTile[e], batch[byTile[e]]) >> 24]++] = byTile[e];
    }
    for (int e = first; e < end; e++) {
        const int k = room[e];
        const uint own = c2d_priority(k, batch[k]);
        int to = e;
        for (; to > first && c2d_priority(byTile[to - 1], batch[byTile[to - 1]]) > own; to--) {
            byTile[to] = byTile[to - 1];
        }
        byTile[to] = k;
    }
}
#endif

// What a group knows of its tile. By circle: `mask`, its colours; from `circles` on, and in `bestOdd`, who comes first in this
// round and in the next. By contact: `tint`, its colour. `counts`: of the colours; of three rounds, whether any contact is left.
#define C2D_TILE                                                                                                       \
    int first, int end, __global const int *other, __global int *byTile, __global uchar *tint, int circles,              \
        __global const int *batch, __global uint *mask, __global uint *bestOdd, __local int *counts

// Colours what waits, as far as there are colours.
static void c2d_batch_page(C2D_TILE) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    for (int c = item; c < C2D_COLOURS + 3; c += items) {
        counts[c] = 0;
    }
    for (int e = first + item; e < end; e += items) {
        const int k = byTile[e];
        if (tint[k] == C2D_WAITS) {
            const int i = batch[k] & INT_MAX;
            const int j = other[k];
            tint[k] = C2D_OPEN;
            mask[i] = 0u;
            mask[j] = 0u;
            mask[circles + i] = UINT_MAX;
            mask[circles + j] = UINT_MAX;
        }
    }
#if C2D_ALONE
    for (int e = first; e < end; e++) {
        const int k = byTile[e];
        if (tint[k] == C2D_OPEN) {
            const int colour = c2d_colour(batch[k] & INT_MAX, other[k], mask);
            tint[k] = (uchar)colour;
            counts[colour < C2D_WAITS ? colour : C2D_COLOURS]++;
        }
    }
#else
    __local int *left = counts + C2D_COLOURS;
    int round = 0;
    bool again;
    do {
        __global uint *best = (round & 1) != 0 ? bestOdd : mask + circles;
        __global uint *next = (round & 1) != 0 ? mask + circles : bestOdd;
        barrier(CLK_GLOBAL_MEM_FENCE | CLK_LOCAL_MEM_FENCE);
        for (int e = first + item; e < end; e += items) {
            const int k = byTile[e];
            if (tint[k] == C2D_OPEN) {
                const uint own = c2d_priority(k, batch[k]);
                atomic_min(&best[batch[k] & INT_MAX], own);
                atomic_min(&best[other[k]], own);
            }
        }
        if (item == 0) {
            left[(round + 1) % 3] = 0;
        }
        barrier(CLK_GLOBAL_MEM_FENCE | CLK_LOCAL_MEM_FENCE);
        for (int e = first + item; e < end; e += items) {
            const int k = byTile[e];
            if (tint[k] != C2D_OPEN) {
                continue;
            }
            const uint own = c2d_priority(k, batch[k]);
            const int i = batch[k] & INT_MAX;
            const int j = other[k];
            next[i] = UINT_MAX;
            next[j] = UINT_MAX;
            if (best[i] != own || best[j] != own) {
                left[round % 3] = 1;
                continue;
            }
            const int colour = c2d_colour(i, j, mask);
            tint[k] = (uchar)colour;
            if (colour < C2D_WAITS) {
                atomic_inc(&counts[colour]);
            }
        }
        barrier(CLK_GLOBAL_MEM_FENCE | CLK_LOCAL_MEM_FENCE);
        again = left[round % 3] != 0;
        round++;
    } while (again);
#endif
}

// A tiling, one work-group a tile: contacts go to `pairs` and to the second part of `batch`.
__kernel void c2d_batch_colour(__global const int *other, __global int *byTile, __global uchar *tint, int circles,
                               int capacity, __global int *batch, __global int2 *pairs, __global uint *mask,
                               __global uint *bestOdd, __global const int *tileStart, __global int *tileColours,
                               __global const uint *status, int firstTile, __local int *counts) {
    const int tile = firstTile + (int)get_group_id(0);
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const int first = tileStart[C2D_PARTS * tile];
    const int end = status[C2D_STALLED] != 0u ? first : tileStart[C2D_PARTS * (tile + 1)];
    __global int *colourStart = batch + 2 * capacity + first;
    __local int *sorted = counts + C2D_COLOURS + 3;
    int done = first;
    int colours = 0;
#if C2D_ALONE
    c2d_batch_sort(first, end, byTile, batch, batch + capacity);
#endif
    while (done < end) {
        c2d_batch_page(first, end, other, byTile, tint, circles, batch, mask, bestOdd, counts);
        if (item == 0) {
            int start = done;
            for (int c = 0; c < C2D_COLOURS && counts[c] > 0; c++) {
                const int own = counts[c];
                counts[c] = start;
                colourStart[colours++] = start;
                start += own;
            }
            *sorted = start;
        }
        barrier(CLK_GLOBAL_MEM_FENCE | CLK_LOCAL_MEM_FENCE);
        done = *sorted;
        for (int e = first + item; e < end; e += items) {
            const int k = byTile[e];
            if (tint[k] < C2D_COLOURS) {
                const int to = atomic_inc(&counts[tint[k]]);
                pairs[to] = (int2)(batch[k] & INT_MAX, other[k]);
                batch[capacity + to] = k;
                tint[k] = C2D_DONE;
            }
        }
        barrier(CLK_GLOBAL_MEM_FENCE | CLK_LOCAL_MEM_FENCE);
    }
    if (item == 0) {
        tileColours[tile] = colours;
    }
}
