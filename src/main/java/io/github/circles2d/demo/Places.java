package io.github.circles2d.demo;

import io.github.circles2d.CircleDef;
import io.github.circles2d.Circles2D;
import java.util.SplittableRandom;

/** Where the circles of a {@link Scene} begin. Each method adds {@code circles} circles to a world in the unit square. */
final class Places {
    private static final long SEED = 2014;

    /** Circles of {@link #bullets} for each bullet. */
    private static final int PER_BULLET = 50;

    /** How fast a bullet is, R a second: 40 a step of 1/60 s. */
    private static final double BULLET_SPEED = 40 * 60;

    private Places() {}

    static void thesis(Circles2D world, int circles) {
        SplittableRandom random = random();
        float scale = (float) Math.sqrt(Math.min(1.0, (double) Scene.THESIS_CIRCLES / Math.max(1, circles)));
        CircleDef def = new CircleDef();
        for (int i = 0; i < circles; i++) {
            def.position(0.1f + 0.8f * (float) random.nextDouble(), 0.1f + 0.8f * (float) random.nextDouble());
            def.radius(scale * (0.01f + 0.005f * (float) random.nextDouble()));
            def.mass(mass(random));
            world.addCircle(def);
        }
    }

    static void gas(Circles2D world, int circles) {
        SplittableRandom random = random();
        int side = side(circles);
        float cell = 1f / side;
        CircleDef def = new CircleDef();
        for (int i = 0; i < circles; i++) {
            def.position((i % side + 0.5f) * cell, (i / side + 0.5f) * cell);
            def.radius(cell * (0.2f + 0.1f * (float) random.nextDouble()));
            def.mass(mass(random));
            def.velocity((float) random.nextDouble(-0.2, 0.2), (float) random.nextDouble(-0.2, 0.2));
            world.addCircle(def);
        }
    }

    static void pile(Circles2D world, int circles) {
        scattered(world, circles, 0);
    }

    static void bullets(Circles2D world, int circles) {
        scattered(world, circles, PER_BULLET);
    }

    /**
     * A lattice over the whole box, each circle somewhere in its cell.
     *
     * @param perBullet circles for each bullet; 0 for none
     */
    private static void scattered(Circles2D world, int circles, int perBullet) {
        SplittableRandom random = random();
        SplittableRandom directions = new SplittableRandom(SEED + 1);
        int side = side(circles);
        float cell = 1f / side;
        float largest = (float) Math.sqrt(0.35 / (Math.PI * Math.max(1, circles)));
        CircleDef def = new CircleDef();
        for (int i = 0; i < circles; i++) {
            float radius = largest * (0.66f + 0.34f * (float) random.nextDouble());
            inCell(def, random, (i % side + 0.5f) * cell, (i / side + 0.5f) * cell, cell, radius);
            def.mass(mass(random)).velocity(0, 0);
            if (perBullet > 0 && i % perBullet == 0) {
                double angle = 2 * Math.PI * directions.nextDouble();
                double speed = BULLET_SPEED * largest;
                def.velocity((float) (speed * StrictMath.cos(angle)), (float) (speed * StrictMath.sin(angle)));
                def.mass(10);
            }
            world.addCircle(def);
        }
    }

    /** Columns of {@link Scene#COLUMN_HEIGHT} circles and a rest, at equal distances; {@code top} is the mass on top. */
    static void columns(Circles2D world, int circles, float top) {
        int height = Math.max(1, Math.min(circles, Scene.COLUMN_HEIGHT));
        int columns = (circles + height - 1) / height;
        // a fifth of the distance between columns stays free
        float radius = Math.min(0.4f / height, 0.4f / Math.max(1, columns));
        for (int i = 0; i < circles; i++) {
            int level = i % height;
            boolean last = level == height - 1 || i == circles - 1;
            float x = (i / height + 0.5f) / columns;
            world.addCircle(x, radius * (2 * level + 1), radius, last ? top : 1);
        }
    }

    static void dam(Circles2D world, int circles) {
        SplittableRandom random = random();
        float width = 1 / 3f;
        float height = 0.95f;
        int across = Math.max(1, (int) Math.sqrt(circles * (width / height)));
        int rows = (circles + across - 1) / across;
        float cell = Math.min(width / across, height / Math.max(1, rows));
        CircleDef def = new CircleDef();
        for (int i = 0; i < circles; i++) {
            float radius = 0.49f * cell * (0.8f + 0.2f * (float) random.nextDouble());
            inCell(def, random, (i % across + 0.5f) * cell, (i / across + 0.5f) * cell, cell, radius);
            def.mass(10 - 9 * (i / across) / (float) rows);
            world.addCircle(def);
        }
    }

    /** Radius and a random place within a square cell with this middle, from which the circle does not stick out. */
    static void inCell(CircleDef def, SplittableRandom random, float x, float y, float cell, float radius) {
        float free = 0.99f * Math.max(0, cell / 2 - radius);
        def.position(x + free * (float) random.nextDouble(-1, 1), y + free * (float) random.nextDouble(-1, 1));
        def.radius(radius);
    }

    /** The same numbers in every run. */
    static SplittableRandom random() {
        return new SplittableRandom(SEED);
    }

    /** Masses from 1 to 10. */
    static float mass(SplittableRandom random) {
        return 1 + 9 * (float) random.nextDouble();
    }

    /** Cells along a side of a square lattice with one for each circle. */
    static int side(int circles) {
        return Math.max(1, (int) Math.ceil(Math.sqrt(circles)));
    }
}
