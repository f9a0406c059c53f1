// Puts the contacts in the order in which they are solved: pipeline.Tiles says which tile a contact belongs to, and within a
// tile contacts have colours, so that those of one colour share no circle. Twin of host.Batch.
//
// Here contacts, and circles, go to their tiles; batch_colour.cl and batch_order.cl do the rest, or, in the local memory of a
// work-group, batch_local.cl and batch_place.cl.
//
// `batch` has three parts of `capacity` ints. By contact: its circle `owner`, in whose list it is; which of its part of its
// tile it was counted as; that part. Then, in the order of solving: `solved`, of each contact its circles, both or one of them
// (batch_order.cl); and, from the first contact of a tile on, where its colours begin.
// `tileStart`: the first contact of each part of each tile. `code`: by contact, that of its bucket.

#define C2D_SIDE s1
#define C2D_COLUMNS s2
#define C2D_ROWS s3
#define C2D_FIRST s4

static int c2d_tile(int2 cell, int8 tiling) {
    int column = (cell.x + tiling.s0) / tiling.C2D_SIDE;
    int row = (cell.y + tiling.s0) / tiling.C2D_SIDE;
    column = column < tiling.C2D_COLUMNS ? column : column % tiling.C2D_COLUMNS;
    row = row < tiling.C2D_ROWS ? row : row % tiling.C2D_ROWS;
    return tiling.C2D_FIRST + column * tiling.C2D_ROWS + row;
}

// The contacts of a tile, and its circles, are counted in so many parts, by rows of cells: what is of one row lies together in
// memory.
#define C2D_PARTS 8
static int c2d_batch_part(int tile, int row) { return C2D_PARTS * tile + row % C2D_PARTS; }

// By place: which of its part a circle was counted as.
#define C2D_TURN_OF C2D_AT(int, from)
#define C2D_MASK C2D_AT(ulong, kicked)

// As which of its part each of four neighbours is counted; `part`: their parts, -1 for none. Those of one part are counted in one
// go, for counting into one place takes turns.
static int4 c2d_batch_turns(int4 part, __global int *tileStart) {
    const int z = part.w == part.z ? 2 : 1;
    const int y = part.z == part.y ? 1 + z : 1;
    const int x = part.y == part.x ? 1 + y : 1;
    int4 turn = (int4)(0, 0, 0, 0);
    if (part.x >= 0) {
        turn.x = atomic_add(&tileStart[part.x + 1], x);
    }
    turn.y = turn.x + 1;
    if (part.y >= 0 && part.y != part.x) {
        turn.y = atomic_add(&tileStart[part.y + 1], y);
    }
    turn.z = turn.y + 1;
    if (part.z >= 0 && part.z != part.y) {
        turn.z = atomic_add(&tileStart[part.z + 1], z);
    }
    turn.w = turn.z + 1;
    if (part.w >= 0 && part.w != part.z) {
        turn.w = atomic_add(&tileStart[part.w + 1], 1);
    }
    return turn;
}

// What colours need to know of the bucket of a circle: not of its cell, for in a bucket of a folded level circles of several come by
// turns, and all of them are one run. Its class: classes are levels, and of each level columns modulo 3 and rows modulo 2, 3 at wider
// levels; folded levels leave these as they are. And its bin, so that what is near each other, but not of one bucket, is in
// different ones.
#define C2D_BINS 64
#define C2D_CLASS(code) ((code) & 0xFF)
#define C2D_BIN(code) ((code) >> 8)
static int c2d_batch_code(int4 cell, __global const int8 *levels) {
    const int8 level = levels[1 + cell.z];
    int x = cell.x >> level.C2D_SHIFT;
    int y = cell.y >> level.C2D_SHIFT;
    if (c2d_is_folded(level)) {
        const int bucket = c2d_bucket(level, x, y) - level.C2D_BASE;
        x = bucket % level.C2D_WIDTH;
        y = bucket / level.C2D_WIDTH;
    }
    const int class = (cell.z == 0 ? 0 : 9 * cell.z - 3) + 3 * (y % (cell.z == 0 ? 2 : 3)) + x % 3;
    return class | (x % 8 + 8 * (y % 8)) << 8;
}

static int c2d_batch_classes(int levelCount) { return 9 * levelCount - 3; }

// The part of contact k, of those of its tile.
static int c2d_batch_part_of(int k, int contacts, __global const float8 *body, __global const int8 *levels,
                             __global const int8 *tilings, const c2d_numbers numbers, __global const int *other,
                             __global const int *batch, __global ushort *code) {
    if (k >= contacts) {
        return -1;
    }
    const int4 cell = c2d_cell(body[batch[k]], levels, numbers);
    const int2 a = cell.xy;
    const int2 b = c2d_finest_cell(body[other[k]].s01, levels[0], numbers);
    // the last tiling holds whatever those before do not
    int tiling = -1;
    int tile;
    do {
        tiling++;
        tile = c2d_tile(a, tilings[tiling]);
    } while (tile != c2d_tile(b, tilings[tiling]));
    code[k] = (ushort)c2d_batch_code(cell, levels);
    return c2d_batch_part(tile, a.y);
}

// Contacts 4 q to 4 q + 3; there is always room for a multiple of four.
static void c2d_batch_count_at(int q, int contacts, __global const float8 *body, __global const int8 *levels,
                               __global const int8 *tilings, const c2d_numbers numbers, __global const int *other,
                               int capacity, __global int *batch, __global int *tileStart, __global ushort *code) {
    int4 part = (int4)(-1, -1, -1, -1);
#pragma unroll 1
    for (int k = 4 * q; k < 4 * q + 4; k++) {
        part = (int4)(part.y, part.z, part.w, c2d_batch_part_of(k, contacts, body, levels, tilings, numbers, other, batch, code));
    }
    ((__global int4 *)(batch + capacity))[q] = c2d_batch_turns(part, tileStart);
    ((__global int4 *)(batch + 2 * capacity))[q] = part;
}

// The part of the circle at place p: circles are counted after the contacts of all `tiles`, by tiles of the first tiling.
static int c2d_batch_part_of_circle(int p, int circles, __global const float8 *body, int8 all, __global const int8 *tilings,
                                    const c2d_numbers numbers, int tiles) {
    if (p >= circles) {
        return -1;
    }
    const int2 cell = c2d_finest_cell(body[p].s01, all, numbers);
    return c2d_batch_part(tiles + c2d_tile(cell, tilings[0]), cell.y);
}

// One work-item four contacts, going round where they are more; and four circles.
__kernel void c2d_batch_count(C2D_WORLD, int tiles) {
    const int8 all = C2D_LEVEL_TABLE[0];
    const bool stalled = status[C2D_STALLED] != 0u;
    const int contacts = stalled ? 0 : C2D_LIST_START[world.circles];
    for (int q = (int)get_global_id(0); 4 * q < contacts; q += (int)get_global_size(0)) {
        c2d_batch_count_at(q, contacts, C2D_BODY, C2D_LEVEL_TABLE, C2D_TILING_TABLE, world.numbers, C2D_OTHER,
                           world.capacity, C2D_BATCH, C2D_TILE_START, C2D_CODE);
    }
    const int circles = stalled ? 0 : world.circles;
    for (int q = (int)get_global_id(0); 4 * q < circles; q += (int)get_global_size(0)) {
        int4 part = (int4)(-1, -1, -1, -1);
#pragma unroll 1
        for (int p = 4 * q; p < 4 * q + 4; p++) {
            part = (int4)(part.y, part.z, part.w,
                          c2d_batch_part_of_circle(p, circles, C2D_BODY, all, C2D_TILING_TABLE, world.numbers, tiles));
        }
        ((__global int4 *)C2D_TURN_OF)[q] = c2d_batch_turns(part, C2D_TILE_START);
    }
}

// The circles of a tile of the first tiling, from .x to .y of `members`.
static int2 c2d_members(int tile, int tiles, __global const int *tileStart) {
    const int contacts = tileStart[C2D_PARTS * tiles];
    return (int2)(tileStart[C2D_PARTS * (tiles + tile)] - contacts, tileStart[C2D_PARTS * (tiles + tile + 1)] - contacts);
}

// Lists a tile if there is anything in it; whoever comes first, for tiles of one tiling have nothing to do with each other.
static void c2d_batch_live(int tile, int tiles, int tilings, __global const int8 *table, __global const int *tileStart,
                           __global int *live) {
    const int2 own = tile < table[1].C2D_FIRST ? c2d_members(tile, tiles, tileStart) : (int2)(0, 0);
    if (own.x < own.y || tileStart[C2D_PARTS * tile] < tileStart[C2D_PARTS * (tile + 1)]) {
        int tiling = 0;
        while (tiling + 1 < tilings && tile >= table[tiling + 1].C2D_FIRST) {
            tiling++;
        }
        live[C2D_TILINGS + table[tiling].C2D_FIRST + atomic_inc(&live[tiling])] = tile;
    }
}

__kernel void c2d_batch_fill(C2D_WORLD, int tiles, int tilings) {
    const int8 all = C2D_LEVEL_TABLE[0];
    const bool stalled = status[C2D_STALLED] != 0u;
    const int contacts = stalled ? 0 : C2D_LIST_START[world.circles];
#pragma unroll 1
    for (int k = (int)get_global_id(0); k < contacts; k += (int)get_global_size(0)) {
        const int part = C2D_BATCH[2 * world.capacity + k];
        C2D_BY_TILE[C2D_TILE_START[part] + C2D_BATCH[world.capacity + k]] = k;
    }
    for (int p = (int)get_global_id(0); p < (stalled ? 0 : world.circles); p += (int)get_global_size(0)) {
        const int part =
            c2d_batch_part_of_circle(p, world.circles, C2D_BODY, all, C2D_TILING_TABLE, world.numbers, tiles);
        C2D_MEMBERS[C2D_TILE_START[part] - contacts + C2D_TURN_OF[p]] = p;
        C2D_TURN_OF[p] = 0;
        C2D_MASK[p] = 0ul;
    }
    for (int tile = (int)get_global_id(0); tile < (C2D_GPU && !stalled ? tiles : 0); tile += (int)get_global_size(0)) {
        c2d_batch_live(tile, tiles, tilings, C2D_TILING_TABLE, C2D_TILE_START, C2D_LIVE);
    }
}
