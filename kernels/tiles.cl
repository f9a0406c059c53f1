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

// Of three tilings, the tile of the last that lies `which` & 1 columns and `which` >> 1 rows farther than a tile of another; numbers
// come round.
static int c2d_farther(int tile, int tiling, int which, __global const int8 *tilings) {
    const int8 from = tilings[tiling];
    const int own = tile - from.C2D_FIRST;
    const int column = (own / from.C2D_ROWS + (which & 1)) % from.C2D_COLUMNS;
    const int row = (own % from.C2D_ROWS + (which >> 1)) % from.C2D_ROWS;
    return tilings[2].C2D_FIRST + column * from.C2D_ROWS + row;
}
