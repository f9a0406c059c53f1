package io.github.circles2d.demo;

import io.github.circles2d.CircleDef;
import io.github.circles2d.Circles2D;
import java.util.SplittableRandom;

/** Where the circles of a {@link Scene} with very different radii begin; an instance is the boulders of one. */
final class Boulders {
    /** Radius of a boulder, radii of the largest of the other circles. */
    private static final double RATIO = 8;

    /** Mean square of radii that are uniform from 0.66 to 1. */
    private static final double MEAN_SQUARE = (1 + 0.66 + 0.66 * 0.66) / 3;

    /** Cells along a side of the lattice of {@link #mixed}'s boulders. */
    private final int side;

    private final float radius;
    private final float[] x;
    private final float[] y;

    static void pebbles(Circles2D world, int circles) {
        SplittableRandom random = Places.random();
        // radii r between 1 and 30 with a density of 1/r^3 have a mean square of 2 ln 30 / (1 - 1/900)
        double smallest = Math.sqrt(0.35 / (Math.PI * Math.max(1, circles) * 2 * StrictMath.log(30) / (1 - 1 / 900.0)));
        CircleDef def = new CircleDef();
        for (int i = 0; i < circles; i++) {
            double size = 1 / Math.sqrt(1 - random.nextDouble() * (1 - 1 / 900.0));
            float radius = (float) Math.min(0.2, smallest * size);
            def.position(
                    radius + (1 - 2 * radius) * (float) random.nextDouble(),
                    radius + (1 - 2 * radius) * (float) random.nextDouble());
            def.radius(radius);
            def.mass((float) (size * size));
            world.addCircle(def);
        }
    }

    static void mixed(Circles2D world, int circles) {
        int boulders = Math.min(circles, Math.max(1, circles / 100));
        int small = circles - boulders;
        double largest = Math.sqrt(0.35 / (Math.PI * Math.max(1, RATIO * RATIO * boulders + MEAN_SQUARE * small)));
        SplittableRandom random = Places.random();
        Boulders placed = new Boulders(boulders, (float) (RATIO * largest), random);
        CircleDef def = new CircleDef().radius(placed.radius);
        for (int b = 0; b < boulders; b++) {
            def.position(placed.x[b], placed.y[b]).mass((float) (RATIO * RATIO) * Places.mass(random));
            world.addCircle(def);
        }
        // the coarsest lattice, within 2 %, that has a free cell for each of the others
        int side = Places.side(small);
        while (placed.freeCells(side) < small) {
            side += 1 + side / 50;
        }
        float cell = 1f / side;
        for (int c = 0, left = small; left > 0; c++) {
            if (placed.isFree(c, side)) {
                float radius = (float) largest * (0.66f + 0.34f * (float) random.nextDouble());
                Places.inCell(def, random, (c % side + 0.5f) * cell, (c / side + 0.5f) * cell, cell, radius);
                world.addCircle(def.mass(Places.mass(random)));
                left--;
            }
        }
    }

    /** One boulder somewhere in each cell of a square lattice over the box, without sticking out of it. */
    private Boulders(int count, float radius, SplittableRandom random) {
        side = Places.side(count);
        this.radius = radius;
        x = new float[count];
        y = new float[count];
        float cell = 1f / side;
        float free = 0.99f * (cell / 2 - radius);
        for (int b = 0; b < count; b++) {
            x[b] = (b % side + 0.5f) * cell + free * (float) random.nextDouble(-1, 1);
            y[b] = (b / side + 0.5f) * cell + free * (float) random.nextDouble(-1, 1);
        }
    }

    private int freeCells(int fineSide) {
        int free = 0;
        for (int c = 0; c < fineSide * fineSide; c++) {
            free += isFree(c, fineSide) ? 1 : 0;
        }
        return free;
    }

    /** Whether a cell of a finer lattice is clear of the boulders. */
    private boolean isFree(int cell, int fineSide) {
        float half = 0.5f / fineSide;
        float middleX = (2 * (cell % fineSide) + 1) * half;
        float middleY = (2 * (cell / fineSide) + 1) * half;
        for (int row = row(middleY - half); row <= row(middleY + half); row++) {
            for (int column = row(middleX - half); column <= row(middleX + half); column++) {
                int b = row * side + column;
                if (b < x.length) {
                    // from the boulder to the nearest point of the cell
                    float dx = Math.max(0, Math.abs(x[b] - middleX) - half);
                    float dy = Math.max(0, Math.abs(y[b] - middleY) - half);
                    if (dx * dx + dy * dy < radius * radius) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    /** Row, or column, of the boulders' lattice. */
    private int row(float coordinate) {
        return Math.min(side - 1, Math.max(0, (int) (coordinate * side)));
    }
}
