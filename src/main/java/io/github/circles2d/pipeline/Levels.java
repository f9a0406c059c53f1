package io.github.circles2d.pipeline;

import java.util.Arrays;

/**
 * The cells of {@link io.github.circles2d.Solver#SMALL_STEPS}, in levels: cells of level k are 2^k times as wide as the
 * finest, and each circle lies in the finest level whose cells are as wide as its reach. Only levels with circles exist.
 *
 * <p>The cell of a position at level k is its finest cell shifted right by k, so that a circle has exactly one cell at
 * every level. A level with many more cells than circles is folded into a torus of buckets, sheared, so that cells near
 * each other never share one; columns are then a multiple of 3 and rows of 2, and cells of one colour stay apart.
 *
 * <p>Circles are kept by bucket, row by row. Contacts are kept by owner, colour by colour: those of the buckets whose x mod
 * 3 and y mod 2 agree lie in a row. Both count from the {@link #BASE} of their level. Twin of the functions of {@code
 * kernels/small.cl}.
 */
public final class Levels {
    /** Owners of one colour share no circle: x mod 3 and y mod 2 agree. */
    public static final int COLOURS = 6;

    /** Numbers of one level in {@link #table}: an int8 in the kernels. */
    public static final int INTS = 8;

    /** How far the number of a finest cell is shifted to give that of this level's. */
    public static final int SHIFT = 0;
    /** Last column and row of cells. */
    public static final int LAST_X = 1;

    public static final int LAST_Y = 2;
    /** Columns and rows of buckets. */
    public static final int WIDTH = 3;

    public static final int HEIGHT = 4;
    /** Rows that a folded level is moved by from one turn to the next. */
    public static final int SHEAR = 5;
    /** First bucket, and first owner. */
    public static final int BASE = 6;
    /** Owners of one colour. */
    public static final int OWNERS = 7;

    /** The levels, finest first, {@link #INTS} numbers each. */
    public final int[] table;
    /** Number of levels. */
    public final int count;
    /** Buckets of all levels, and owners. */
    public final int cells;
    /** Finest cells along one world unit. */
    public final float perUnit;
    /** Number of circles. */
    public final int circles;

    private final float finest;

    private Levels(WorldConfig config, Population population) {
        circles = population.circles();
        double width = (double) config.maxX() - config.minX();
        double height = (double) config.maxY() - config.minY();
        double least = Math.max(width, height) / Tuning.MAX_FINE_CELLS_PER_AXIS;
        float size = (float) Math.max(least, reach(population.maxRadius()));
        int levels = 1;
        while (levels < Tuning.LEVELS && size / 2 >= least && size / 2 >= reach(population.minRadius())) {
            size /= 2;
            levels++;
        }
        finest = size;
        perUnit = 1 / size;
        boolean[] occupied = new boolean[levels];
        population.radii(radius -> occupied[Math.min(levels(radius), occupied.length - 1)] = true);
        int[] made = new int[INTS * levels];
        int at = 0;
        int base = 0;
        for (int shift = 0; shift < levels; shift++) {
            if (occupied[shift]) {
                level(made, at, shift, (int) (width * perUnit) >> shift, (int) (height * perUnit) >> shift);
                made[at + BASE] = base;
                base += COLOURS * made[at + OWNERS];
                at += INTS;
            }
        }
        table = Arrays.copyOf(made, at);
        count = at / INTS;
        cells = base;
    }

    /** The levels for the circles of a world. */
    public static Levels of(WorldConfig config, Population population) {
        return new Levels(config, population);
    }

    private static float reach(float radius) {
        return 2 * radius * (1 + Tuning.REACH);
    }

    /** Level, counted in doublings, whose cells are as wide as the reach of a circle. */
    private int levels(float radius) {
        int level = 0;
        // the widest cells come from halving: rounding must not push their circles a level up
        for (float size = finest; level < Tuning.LEVELS - 1 && size < reach(radius) * 0.999f; size *= 2) {
            level++;
        }
        return level;
    }

    /** Number of the level of a circle among those that exist. */
    public int levelOf(float radius) {
        int level = levels(radius);
        int number = 0;
        while (number < count - 1 && table[INTS * number + SHIFT] < level) {
            number++;
        }
        return number;
    }

    private void level(int[] made, int at, int shift, int lastX, int lastY) {
        long columns = lastX + 1L;
        long rows = lastY + 1L;
        if (columns * rows > Math.max(64, (long) Tuning.LEVEL_CELLS_PER_CIRCLE * circles)) {
            double wanted = Math.max(36, (double) Tuning.FOLDED_CELLS_PER_CIRCLE * circles);
            double across = Math.min(columns, Math.max(6, Math.floor(Math.sqrt(wanted))));
            double up = Math.min(rows, Math.max(6, Math.floor(wanted / across)));
            if (up < wanted / across) {
                across = Math.min(columns, wanted / up);
            }
            columns = (Math.max(6, (int) across) + 2) / 3 * 3;
            rows = (Math.max(6, (int) up) + 1) / 2 * 2;
            made[at + SHEAR] = 2 * (int) (Tuning.FOLD_SHIFT * rows);
        }
        made[at + SHIFT] = shift;
        made[at + LAST_X] = lastX;
        made[at + LAST_Y] = lastY;
        made[at + WIDTH] = (int) columns;
        made[at + HEIGHT] = (int) rows;
        made[at + OWNERS] = (int) ((columns + 2) / 3 * ((rows + 1) / 2));
    }

    /** Column of buckets of a column of cells. */
    public static int bucketX(int[] table, int at, int x) {
        return x % table[at + WIDTH];
    }

    /** Row of buckets of a cell. */
    public static int bucketY(int[] table, int at, int x, int y) {
        int width = table[at + WIDTH];
        int height = table[at + HEIGHT];
        return x < width && y < height ? y : (int) ((y + (long) (x / width) * table[at + SHEAR]) % height);
    }

    /** The bucket of a cell of the level that begins at {@code at}. */
    public int bucket(int at, int x, int y) {
        return table[at + BASE] + bucketY(table, at, x, y) * table[at + WIDTH] + bucketX(table, at, x);
    }

    /** The owner that a cell of the level that begins at {@code at} is. */
    public int owner(int at, int x, int y) {
        int column = bucketX(table, at, x);
        int row = bucketY(table, at, x, y);
        return table[at + BASE]
                + (column % 3 + 3 * (row % 2)) * table[at + OWNERS]
                + row / 2 * ((table[at + WIDTH] + 2) / 3)
                + column / 3;
    }

    /** The finest column or row of a coordinate; whatever lies outside, or nowhere, counts to the nearest. */
    public int finest(float coordinate, float min, int last) {
        float cell = (coordinate - min) * perUnit;
        float low = cell > 0 ? cell : 0;
        return (int) (low < last ? low : last);
    }

    /** Last finest column. */
    public int lastColumn(WorldConfig config) {
        return (int) (((double) config.maxX() - config.minX()) * perUnit);
    }

    /** Last finest row. */
    public int lastRow(WorldConfig config) {
        return (int) (((double) config.maxY() - config.minY()) * perUnit);
    }

    /** Whether two have the same cells. */
    public boolean same(Levels other) {
        return other.circles == circles && other.perUnit == perUnit && Arrays.equals(other.table, table);
    }
}
