package io.github.circles2d.pipeline;

/**
 * How the contacts of {@link io.github.circles2d.Solver#SMALL_STEPS} are shared out: the finest cells are tiled with squares,
 * three times over, each time moved on by a third. A contact belongs to the first tile that holds both of its circles, so that
 * contacts of two tiles of one tiling share no circle. One that crosses a border of one tiling crosses none of the
 * next along that axis; of three tilings one at least has it inside. Where there are circles so large that a third of a tile is
 * less than their contacts span, three tilings of larger tiles follow, and so on. Tiles that are too many for the circles
 * share numbers, which changes nothing of this. A small world, {@link Tuning#ALONE_CIRCLES}, is one tile: fewer
 * colours for the one work-group that does it.
 *
 * <p>Twin of {@code c2d_tile} of {@code kernels/batch.cl}.
 */
public final class Tiles {
    /** The contacts of a tile, and its circles, are counted in so many parts: {@code C2D_PARTS}. */
    public static final int PARTS = 8;

    /** There are never so many tilings: {@code C2D_TILINGS}. */
    public static final int MOST_TILINGS = 64;

    /** Numbers of one tiling in {@link #table}: an int8 in the kernels. */
    public static final int INTS = 8;

    /** Finest cells that the tiling is moved by; the side of a tile, finest cells. */
    private static final int OFFSET = 0;

    private static final int SIDE = 1;
    /** Columns and rows of tiles; beyond, numbers come again. */
    private static final int COLUMNS = 2;

    private static final int ROWS = 3;
    /** The first tile. */
    private static final int FIRST = 4;

    /** Tilings, in the order in which contacts are offered to them and solved. */
    public final int tilings;
    /** Tiles of all tilings. */
    public final int tiles;
    /** The tilings, {@link #INTS} numbers each, and one after the last, of which only the first tile means anything. */
    public final int[] table;

    private Tiles(Levels levels) {
        if (levels.oneTile) {
            tilings = 1;
            tiles = 1;
            table = new int[INTS * 2];
            table[SIDE] = Math.max(levels.table[Levels.LAST_X], levels.table[Levels.LAST_Y]) + 1;
            table[COLUMNS] = 1;
            table[ROWS] = 1;
            table[INTS + FIRST] = 1;
            return;
        }
        int widest = 0;
        for (int number = 0; number < levels.count; number++) {
            widest = Math.max(widest, levels.table[Levels.at(number) + Levels.SHIFT]);
        }
        // circles that touch lie in neighbouring cells of the wider level
        long span = (2L << widest) - 1;
        int scales = 1;
        while (side(levels, scales - 1) - 2L * third(side(levels, scales - 1)) < span) {
            scales++;
        }
        tilings = 3 * scales;
        table = new int[INTS * (tilings + 1)];
        int all = 0;
        for (int tiling = 0; tiling < tilings; tiling++) {
            int at = INTS * tiling;
            int side = side(levels, tiling / 3);
            int third = third(side);
            int columns = (levels.table[Levels.LAST_X] + 2 * third) / side + 1;
            int rows = (levels.table[Levels.LAST_Y] + 2 * third) / side + 1;
            int most = Math.max(Tuning.TILES_FEW, levels.circles / Tuning.CIRCLES_PER_TILE);
            if ((long) columns * rows > most) {
                columns = Math.min(columns, Math.max(most / rows, (int) Math.sqrt(most)));
                rows = Math.min(rows, most / columns);
            }
            table[at + OFFSET] = tiling % 3 * third;
            table[at + SIDE] = side;
            table[at + COLUMNS] = columns;
            table[at + ROWS] = rows;
            table[at + FIRST] = all;
            all += columns * rows;
        }
        tiles = all;
        table[INTS * tilings + FIRST] = all;
    }

    /** The tiles over the cells of a world. */
    public static Tiles of(Levels levels) {
        return new Tiles(levels);
    }

    private static int side(Levels levels, int scale) {
        int far = levels.circles > Tuning.MANY ? Tuning.TILE_SIDE_FAR_OF_MANY : Tuning.TILE_SIDE_FAR;
        int smallest = levels.reach > Tuning.REACH ? far : Tuning.TILE_SIDE;
        return (int) Math.min(1L << 28, (long) smallest << Tuning.TILE_SCALE * scale);
    }

    /** Parts that contacts are counted in, and after them the circles of the tiles of the first tiling. */
    public int parts() {
        return PARTS * (tiles + first(1));
    }

    /** What a tiling is moved on by; the borders of the last and the first are nearest to each other. */
    private static int third(int side) {
        return (side + 2) / 3;
    }

    /** First tile of a tiling; of the one after the last, the number of tiles. */
    public int first(int tiling) {
        return table[INTS * tiling + FIRST];
    }

    /** Tiles of a tiling. */
    public int count(int tiling) {
        return first(tiling + 1) - first(tiling);
    }

    /** The tile of a finest cell. */
    public int tile(int tiling, int x, int y) {
        int at = INTS * tiling;
        int column = (x + table[at + OFFSET]) / table[at + SIDE];
        int row = (y + table[at + OFFSET]) / table[at + SIDE];
        return table[at + FIRST] + column % table[at + COLUMNS] * table[at + ROWS] + row % table[at + ROWS];
    }
}
