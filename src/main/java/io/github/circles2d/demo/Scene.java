package io.github.circles2d.demo;

import io.github.circles2d.Circles2D;
import java.util.List;
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
    /** Circles of the thesis' test program; it has no other number. */
    public static final int THESIS_CIRCLES = 1250;

    /**
     * The thesis' test program (chapter 5): circles at rest at random places, overlapping, in a weak gravity. Beyond its
     * 1,250 circles radii shrink so that the circles cover as much of the box as there: 61 % of it (the thesis keeps the
     * radii, and 15,000 circles cover the box seven times).
     */
    public static final Scene THESIS = new Scene("thesis", 0, -0.01f, 0.5f, Places::thesis);

    /** Circles flying about without gravity or loss: the energy stays. Placed on a lattice, apart from each other. */
    public static final Scene GAS = new Scene("gas", 0, 0, 1, Places::gas);

    /**
     * Circles at rest all over the box, apart from each other, that fall and make a pile: they cover at most 35 % of it.
     * Radii from 0.66 R to R, masses from 1 to 10, with {@code R = sqrt(0.35 / (pi n))}.
     */
    public static final Scene PILE = new Scene("pile", 0, -1, 0.5f, Places::pile);

    /**
     * A pile with boulders: as {@link #PILE}, but the first hundredth of the circles, at least one, have the radius 8 R and,
     * as if of the same material, masses from 64 to 640. R is such that all circles together cover 35 % of the box; none
     * overlap at first.
     */
    public static final Scene MIXED = new Scene("mixed", 0, -1, 0.5f, Boulders::mixed);

    /**
     * Radii of all sizes up to 30 times the smallest, as many of each as fill the same area, masses as their areas: a pile
     * of pebbles and boulders. Circles lie at random places and may overlap at first.
     */
    public static final Scene PEBBLES = new Scene("pebbles", 0, -1, 0.5f, Boulders::pebbles);

    /** Most circles that {@link #COLUMN} and {@link #LOADED} put on top of each other. */
    public static final int COLUMN_HEIGHT = 100;

    /**
     * Circles of one size and mass 1 on top of each other, at rest, in the middle of the box. More than
     * {@value #COLUMN_HEIGHT} circles stand in several columns side by side, which do not touch.
     */
    public static final Scene COLUMN =
            new Scene("column", 0, -1, 0.5f, (world, circles) -> Places.columns(world, circles, 1));

    /** As {@link #COLUMN}, but the circle on top of each column has a hundred times the mass of the others. */
    public static final Scene LOADED =
            new Scene("loaded", 0, -1, 0.5f, (world, circles) -> Places.columns(world, circles, 100));

    /**
     * As {@link #PILE}, but every fiftieth circle, from the first on, is a bullet: mass 10, 40 R a step of 1/60 s in any
     * direction, 13 times the distance from one circle to the next. Circles only lose energy here.
     */
    public static final Scene BULLETS = new Scene("bullets", 0, -1, 0.5f, Places::bullets);

    /**
     * A tall block at the left wall, a third of the box wide and nearly as high, that breaks, washes over the floor and up
     * the other wall. Circles at rest and apart from each other, radii from 0.8 R to R, masses from 10 at the floor to 1 at
     * the top, so that the demo's colours show how it flows.
     */
    public static final Scene DAM = new Scene("dam", 0, -1, 0.2f, Places::dam);

    /** Every scene, the default first. */
    public static final List<Scene> ALL = List.of(THESIS, GAS, PILE, MIXED, PEBBLES, COLUMN, LOADED, BULLETS, DAM);

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
