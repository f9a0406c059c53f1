package io.github.circles2d.demo;

import io.github.circles2d.CircleDef;
import io.github.circles2d.Circles2D;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BiConsumer;

/**
 * The worlds that tests, benchmarks and the demo share. A scene of one name and size is the same in every run.
 *
 * @param name what {@link #named} knows it by
 * @param gravityX world units / s^2
 * @param gravityY world units / s^2
 * @param restitution 0 to 1
 * @param circles adds that many circles to a world in the unit square
 */
public record Scene(
        String name, float gravityX, float gravityY, float restitution, BiConsumer<Circles2D, Integer> circles) {
    private static final long SEED = 2014;

    /** Circles of the thesis' test program; it has no other number. */
    public static final int THESIS_CIRCLES = 1250;

    /**
     * The thesis' test program (chapter 5): circles at rest at random places, overlapping, in a weak gravity. Beyond its
     * 1,250 circles radii shrink so that the circles cover as much of the box as there: 61 % of it (the thesis keeps the
     * radii, and 15,000 circles cover the box seven times).
     */
    public static final Scene THESIS = new Scene("thesis", 0, -0.01f, 0.5f, (world, circles) -> {
        SplittableRandom random = new SplittableRandom(SEED);
        float scale = (float) Math.sqrt(Math.min(1.0, (double) THESIS_CIRCLES / Math.max(1, circles)));
        CircleDef def = new CircleDef();
        for (int i = 0; i < circles; i++) {
            def.position(0.1f + 0.8f * (float) random.nextDouble(), 0.1f + 0.8f * (float) random.nextDouble());
            def.radius(scale * (0.01f + 0.005f * (float) random.nextDouble()));
            def.mass(1 + 9 * (float) random.nextDouble());
            world.addCircle(def);
        }
    });

    /** Circles flying about without gravity or loss: the energy stays. Placed on a lattice, apart from each other. */
    public static final Scene GAS = new Scene("gas", 0, 0, 1, (world, circles) -> {
        SplittableRandom random = new SplittableRandom(SEED);
        int side = (int) Math.ceil(Math.sqrt(circles));
        float cell = 1f / Math.max(1, side);
        CircleDef def = new CircleDef();
        for (int i = 0; i < circles; i++) {
            def.position((i % side + 0.5f) * cell, (i / side + 0.5f) * cell);
            def.radius(cell * (0.2f + 0.1f * (float) random.nextDouble()));
            def.mass(1 + 9 * (float) random.nextDouble());
            def.velocity((float) random.nextDouble(-0.2, 0.2), (float) random.nextDouble(-0.2, 0.2));
            world.addCircle(def);
        }
    });

    /**
     * Circles at rest all over the box, apart from each other, that fall and make a pile: they cover at most 35 % of it.
     * Radii from 0.66 R to R, masses from 1 to 10.
     */
    public static final Scene PILE = new Scene("pile", 0, -1, 0.5f, (world, circles) -> {
        SplittableRandom random = new SplittableRandom(SEED);
        int side = (int) Math.ceil(Math.sqrt(circles));
        float cell = 1f / Math.max(1, side);
        float largest = largest(circles);
        CircleDef def = new CircleDef();
        for (int i = 0; i < circles; i++) {
            float radius = largest * (0.66f + 0.34f * (float) random.nextDouble());
            float free = 0.99f * Math.max(0, cell / 2 - radius);
            def.position(
                    (i % side + 0.5f) * cell + free * (float) random.nextDouble(-1, 1),
                    (i / side + 0.5f) * cell + free * (float) random.nextDouble(-1, 1));
            def.radius(radius);
            def.mass(1 + 9 * (float) random.nextDouble());
            world.addCircle(def);
        }
    });

    /**
     * Radii of all sizes up to 30 times the smallest, as many of each as fill the same area, masses as their areas: a pile
     * of pebbles and boulders. Circles lie at random places and may overlap at first.
     */
    public static final Scene MIXED = new Scene("mixed", 0, -1, 0.5f, (world, circles) -> {
        SplittableRandom random = new SplittableRandom(SEED);
        // radii r between 1 and 30 with a density of 1/r^3 have a mean square of 2 ln 30 / (1 - 1/900)
        double smallest = Math.sqrt(0.35 / (Math.PI * Math.max(1, circles) * 2 * Math.log(30) / (1 - 1 / 900.0)));
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
    });

    /** Circles of one size on top of each other, in the middle of the box, at rest. */
    public static final Scene COLUMN = new Scene("column", 0, -1, 0.5f, (world, circles) -> {
        float radius = 0.4f / Math.max(1, circles);
        for (int i = 0; i < circles; i++) {
            world.addCircle(0.5f, radius * (2 * i + 1), radius, 1);
        }
    });

    private static float largest(int circles) {
        return (float) Math.sqrt(0.35 / (Math.PI * Math.max(1, circles)));
    }

    /** Every scene, the default first. */
    public static final List<Scene> ALL = List.of(THESIS, GAS, PILE, MIXED, COLUMN);

    /** The scene of a name. */
    public static Scene named(String name) {
        return ALL.stream()
                .filter(scene -> scene.name.equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("scene = " + name + ": must be one of "
                        + ALL.stream().map(Scene::name).toList()));
    }

    /** A world with the rules of the scene, room for this many circles and none in it. */
    public Circles2D empty(Circles2D.Builder builder, int count) {
        return builder.gravity(gravityX, gravityY)
                .restitution(restitution)
                .bounds(0, 0, 1, 1)
                .capacity(count)
                .build();
    }

    /** A world with this many circles of the scene, from a builder that says where and how it runs. */
    public Circles2D build(Circles2D.Builder builder, int count) {
        Circles2D world = empty(builder, count);
        try {
            circles.accept(world, count);
            return world;
        } catch (RuntimeException e) {
            world.close();
            throw e;
        }
    }
}
