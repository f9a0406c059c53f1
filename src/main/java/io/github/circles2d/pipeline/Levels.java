package io.github.circles2d.pipeline;

import java.util.Arrays;

/**
 * The cells of {@link io.github.circles2d.Solver#SMALL_STEPS}, in levels: cells of level k are 2^k times as wide as the
 * finest, and each circle lies in the finest level whose cells are as wide as its reach. Only levels with circles exist.
 *
 * <p>The cell of a position at level k is its finest cell shifted right by k, so that a circle has exactly one cell at
 * every level. A level with many more cells than circles is folded into a torus of buckets, sheared, so that cells near
 * each other never share one; columns are then a multiple of 3 and rows of 6, and cells of one class stay apart.
 *
 * <p>Circles are kept by bucket, row by row, from the {@link #BASE} of their level on. A bucket's contacts, those in the
 * lists of its circles, touch circles of neighbouring cells: at the finest level of the same row and the next, at others, whose
 * lists have the smaller circles around, of the row before too. Buckets whose x mod 3 and y mod {@link #rows} agree share no
 * circle. Twin of the functions of {@code kernels/small.cl}.
 */
public final class Levels {
    /** Numbers of one level in {@link #table}, and of what is for all of them: an int8 in the kernels. */
    public static final int INTS = 8;

    /** Of all: how many levels; the last of the finest columns and rows; finest cells along one world unit, as bits. */
    private static final int LEVELS = 0;

    private static final int PER_UNIT = 3;

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
    /** First bucket. */
    public static final int BASE = 6;
    /** Largest radius, as bits. */
    private static final int LARGEST = 7;

    /** What is for all of the levels, then the levels, finest first, {@link #INTS} numbers each: {@link #at}. */
    public final int[] table;
    /** Number of levels. */
    public final int count;
    /** Buckets of all levels. */
    public final int cells;
    /** Number of circles. */
    public final int circles;
    /** Whether they are so few that all contacts are one tile. */
    final boolean oneTile;

    /** How far the reach of a circle goes beyond its radius, radii. */
    public final float reach;
    /** How much nearer two circles of cells that are not neighbours may come until they touch, world units. */
    final float room;

    private final float finest;
    private final float perUnit;

    private Levels(WorldConfig config, Population population, float reach) {
        circles = population.circles();
        oneTile = circles <= config.oneTile();
        this.reach = reach;
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
        float[] largest = new float[levels];
        int widest = Math.min(levels(population.maxRadius()), levels - 1);
        if (Math.min(levels(population.minRadius()), levels - 1) == widest) {
            largest[widest] = population.circles() == 0 ? 0 : population.maxRadius();
        } else {
            population.radii(radius -> {
                int level = Math.min(levels(radius), largest.length - 1);
                largest[level] = Math.max(largest[level], radius);
            });
        }
        int[] made = new int[INTS * (levels + 1)];
        made[LAST_X] = (int) (width * perUnit);
        made[LAST_Y] = (int) (height * perUnit);
        made[PER_UNIT] = Float.floatToRawIntBits(perUnit);
        int base = 0;
        float spare = Float.MAX_VALUE;
        for (int shift = 0; shift < levels; shift++) {
            if (largest[shift] > 0) {
                int at = at(made[LEVELS]++);
                level(made, at, shift, made[LAST_X] >> shift, made[LAST_Y] >> shift);
                made[at + BASE] = base;
                made[at + LARGEST] = Float.floatToRawIntBits(largest[shift]);
                base += made[at + WIDTH] * made[at + HEIGHT];
                spare = Math.min(spare, finest * (1 << shift) - 2 * largest[shift]);
            }
        }
        count = made[LEVELS];
        table = Arrays.copyOf(made, at(count));
        cells = base;
        room = spare;
    }

    /** Where a level begins in {@link #table}. */
    public static int at(int level) {
        return INTS * (level + 1);
    }

    /** How many rows apart buckets of one class are. */
    public static int rows(int level) {
        return level == 0 ? 2 : 3;
    }

    /**
     * The levels for the circles of a world.
     *
     * @param reach how far the reach of a circle goes beyond its radius, radii
     */
    public static Levels of(WorldConfig config, Population population, float reach) {
        return new Levels(config, population, reach);
    }

    /** The levels of a world for {@link Tuning#REACH} and {@link Tuning#REACH_FAR}. */
    public static Levels[] all(WorldConfig config, Population population) {
        return new Levels[] {of(config, population, Tuning.REACH), of(config, population, Tuning.REACH_FAR)};
    }

    private float reach(float radius) {
        return 2 * radius * (1 + reach);
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
        int number = 0;
        while (number < count - 1 && radius > Float.intBitsToFloat(table[at(number) + LARGEST])) {
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
            rows = (Math.max(6, (int) up) + 5) / 6 * 6;
            made[at + SHEAR] = 6 * (int) (Tuning.FOLD_SHIFT * rows / 6);
        }
        made[at + SHIFT] = shift;
        made[at + LAST_X] = lastX;
        made[at + LAST_Y] = lastY;
        made[at + WIDTH] = (int) columns;
        made[at + HEIGHT] = (int) rows;
    }

    /** Whether cells of a level, which begins at {@code at}, share buckets. */
    public boolean folded(int at) {
        return table[at + LAST_X] >= table[at + WIDTH] || table[at + LAST_Y] >= table[at + HEIGHT];
    }

    /** The bucket of a cell of the level that begins at {@code at}. */
    public int bucket(int at, int x, int y) {
        int width = table[at + WIDTH];
        int height = table[at + HEIGHT];
        int column = x;
        int row = y;
        if (x >= width || y >= height) {
            column = x % width;
            row = (int) ((y + (long) (x / width) * table[at + SHEAR]) % height);
        }
        return table[at + BASE] + row * width + column;
    }

    /** The finest column of a coordinate; whatever lies outside, or nowhere, counts to the nearest. */
    public int column(float x, float min) {
        return finest(x, min, table[LAST_X]);
    }

    /** The finest row of a coordinate, as {@link #column}. */
    public int row(float y, float min) {
        return finest(y, min, table[LAST_Y]);
    }

    private int finest(float coordinate, float min, int last) {
        float cell = (coordinate - min) * perUnit;
        float low = cell > 0 ? cell : 0;
        return (int) (low < last ? low : last);
    }

    /** Whether two have the same cells and tiles. */
    public boolean same(Levels other) {
        return other.circles == circles && other.reach == reach && Arrays.equals(other.table, table);
    }
}
