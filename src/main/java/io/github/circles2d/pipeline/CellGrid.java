package io.github.circles2d.pipeline;

/**
 * The square cells that own contacts: wider than the largest circle, so that circles that touch lie in neighbouring
 * cells. Twin of {@code c2d_cell}, {@code c2d_owner} and {@code c2d_owner_of} in {@code kernels/}.
 *
 * @param minX low corner of the world, world units
 * @param minY low corner of the world, world units
 * @param perUnit cells along one world unit
 * @param columns cells along x, at least 1
 * @param rows cells along y, at least 1
 */
public record CellGrid(float minX, float minY, float perUnit, int columns, int rows) {
    /** Owners of one colour share no circle: x mod 3 and y mod 2 agree. */
    public static final int COLOURS = 6;

    /** Cells for {@code circles} circles of at most {@code maxRadius} (world units) in the bounds of {@code config}. */
    public static CellGrid of(WorldConfig config, int circles, float maxRadius) {
        double width = (double) config.maxX() - config.minX();
        double height = (double) config.maxY() - config.minY();
        double cell = 2.0 * maxRadius * (1.0 + Tuning.CELL_MARGIN);
        cell = Math.max(cell, Math.max(width, height) / (Tuning.MAX_CELLS_PER_AXIS - 1));
        cell = Math.max(cell, Math.sqrt(width * height / Math.max(1.0, (double) Tuning.CELLS_PER_CIRCLE * circles)));
        float perUnit = (float) (1.0 / cell);
        return new CellGrid(
                config.minX(),
                config.minY(),
                perUnit,
                1 + (int) (float) (width * perUnit),
                1 + (int) (float) (height * perUnit));
    }

    /** Number of cells. */
    public int cells() {
        return columns * rows;
    }

    /** The cell of a position, row by row; positions outside count to the nearest cell. */
    public int cell(float x, float y) {
        int column = (int) ((x - minX) * perUnit);
        int row = (int) ((y - minY) * perUnit);
        return Math.min(Math.max(row, 0), rows - 1) * columns + Math.min(Math.max(column, 0), columns - 1);
    }

    /** Owner cells of a colour, 0 to {@link #COLOURS} - 1. */
    public int owners(int colour) {
        int across = (columns - colour % 3 + 2) / 3;
        int up = (rows - colour / 3 + 1) / 2;
        return Math.max(across, 0) * Math.max(up, 0);
    }

    /** Owner cell number {@code item}, 0 to {@code owners(colour)} - 1, of a colour. */
    public int owner(int item, int colour) {
        int across = (columns - colour % 3 + 2) / 3;
        int line = item / across;
        return (colour / 3 + 2 * line) * columns + colour % 3 + 3 * (item - line * across);
    }
}
