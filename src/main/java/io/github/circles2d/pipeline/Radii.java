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
        min = Math.min(min, radius);
        max = Math.max(max, radius);
        sum += radius;
        squares += (double) radius * radius;
    }

    /**
     * The circles that these are the radii of.
     *
     * @param circle (x, y, radius, mass) a circle, world units
     */
    public Population population(FloatBuffer circle) {
        return circles == 0
                ? new Population(circle, 0, 1, 1, 1, 0)
                : new Population(circle, circles, min, max, sum / circles, Math.PI * squares);
    }
}
