package io.github.circles2d.pipeline;

import java.nio.FloatBuffer;

/** What is known of the radii of a world's circles, kept up to date as they are added: to go through a million again takes as long as a step. */
public final class Radii {
    private int circles;
    private float min = Float.MAX_VALUE;
    private float max;
    private double sum;
    private double squares;

    /** Adds that of one circle, world units. */
    public void add(float radius) {
        circles++;
        min = radius < min ? radius : min;
        max = radius > max ? radius : max;
        sum += radius;
        squares += (double) radius * radius;
    }

    /**
     * The circles that these are the radii of.
     *
     * @param transforms as {@link Population} has them; so the masses
     */
    public Population population(FloatBuffer transforms, FloatBuffer masses) {
        return circles == 0
                ? new Population(transforms, masses, 0, 1, 1, 1, 0)
                : new Population(transforms, masses, circles, min, max, sum / circles, Math.PI * squares);
    }
}
