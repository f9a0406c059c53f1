package io.github.circles2d.pipeline;

import java.nio.FloatBuffer;

/**
 * How fast circles are: what a step of {@link io.github.circles2d.Solver#SMALL_STEPS} is cut by. Where all of them move much the same way,
 * as when they fall, no two part fast. In worlds of many circles that counts; in others, the price of it would.
 */
public final class Speeds {
    private float fastest;
    private float maxX;
    private float maxMinusX;
    private float maxY;
    private float maxMinusY;
    private boolean ranges;

    /** Whether the ranges of velocities are worth knowing. */
    public static boolean ranges(int circles) {
        return circles > Tuning.MANY;
    }

    /** None yet, of a world of so many circles. */
    public Speeds clear(int circles) {
        fastest = 0;
        maxX = Float.NEGATIVE_INFINITY;
        maxMinusX = Float.NEGATIVE_INFINITY;
        maxY = Float.NEGATIVE_INFINITY;
        maxMinusY = Float.NEGATIVE_INFINITY;
        ranges = ranges(circles);
        return this;
    }

    /** Adds a circle. The arithmetic is that of {@code c2d_publish}. */
    public void add(float vx, float vy, float radius) {
        float speed = (float) Math.sqrt(vx * vx + vy * vy) / radius;
        fastest = speed > fastest ? speed : fastest;
        if (ranges) {
            maxX = Math.max(maxX, vx);
            maxMinusX = Math.max(maxMinusX, -vx);
            maxY = Math.max(maxY, vy);
            maxMinusY = Math.max(maxMinusY, -vy);
        }
    }

    /** Sets the highest speed, radii a second. */
    public Speeds fastest(float radiiASecond) {
        fastest = radiiASecond;
        return this;
    }

    /** Sets the ranges: the highest of vx, -vx, vy and -vy, world units a second. */
    public void ranges(float x, float minusX, float y, float minusY) {
        maxX = x;
        maxMinusX = minusX;
        maxY = y;
        maxMinusY = minusY;
    }

    /** Those of a world's circles. */
    Speeds of(Population population, FloatBuffer velocities) {
        clear(population.circles());
        for (int i = 0; i < population.circles(); i++) {
            add(
                    velocities.get(2 * i),
                    velocities.get(2 * i + 1),
                    population.circle().get(4 * i + 2));
        }
        return this;
    }

    /** The highest, radii a second. */
    public float fastest() {
        return fastest;
    }

    /** What two circles part by at most, radii a second. */
    float apart(Population population) {
        if (!ranges) {
            return 2 * fastest;
        }
        float x = maxX + maxMinusX;
        float y = maxY + maxMinusY;
        return Math.min(2 * fastest, (float) Math.sqrt(x * x + y * y) / population.minRadius());
    }
}
