// Where the tiles of small steps lie. Twin of pipeline.Tiles, which says why.

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

// The tile of tiling `to` that lies so many columns and rows from `tile` of tiling `from`; numbers come round.
static int c2d_beside(int tile, int8 from, int8 to, int columns, int rows) {
    const int own = tile - from.C2D_FIRST;
    const int column = (own / from.C2D_ROWS + columns + from.C2D_COLUMNS) % from.C2D_COLUMNS;
    const int row = (own % from.C2D_ROWS + rows + from.C2D_ROWS) % from.C2D_ROWS;
    return to.C2D_FIRST + column * to.C2D_ROWS + row;
}

// Around a tile of the last tiling, which is moved on farthest, are of the first tiling one that lies left and below, one below and
// one left of it; of the second its own, one left and one below. And the other way round.
static int c2d_around(int tile, int tiling, int which, bool fromLast, __global const int8 *tilings) {
    const int left = tiling == 0 ? which != 1 : which == 1;
    const int below = tiling == 0 ? which != 2 : which == 2;
    return fromLast ? c2d_beside(tile, tilings[2], tilings[tiling], -left, -below)
                    : c2d_beside(tile, tilings[tiling], tilings[2], left, below);
}
