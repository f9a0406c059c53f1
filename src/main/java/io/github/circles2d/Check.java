package io.github.circles2d;

import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;

/** Checks of arguments: the message names the argument, its value and what is allowed. */
final class Check {
    private Check() {}

    /** A number from {@code min} to {@code max}; NaN is neither. */
    static float range(String name, float value, float min, float max) {
        if (!(value >= min && value <= max)) {
            throw new IllegalArgumentException(name + " = " + value + ": must be from " + min + " to " + max);
        }
        return value;
    }

    /** A number of either sign, up to {@code max}. */
    static float magnitude(String name, float value, float max) {
        return range(name, value, -max, max);
    }

    static int range(String name, int value, int min, int max) {
        if (value < min || value > max) {
            throw new IllegalArgumentException(name + " = " + value + ": must be from " + min + " to " + max);
        }
        return value;
    }

    /** What a circle of such a world may be. */
    static void circle(WorldConfig config, float x, float y, float radius, float mass) {
        range("x", x, config.minX(), config.maxX());
        range("y", y, config.minY(), config.maxY());
        range("radius", radius, Tuning.MIN_RADIUS, Tuning.MAX_RADIUS);
        range("mass", mass, Tuning.MIN_MASS, Tuning.MAX_MASS);
        // as the kernels compute it: a circle fits if its centre has somewhere to be
        if (config.minX() + radius > config.maxX() - radius || config.minY() + radius > config.maxY() - radius) {
            throw new IllegalArgumentException("radius = " + radius + ": the circle must fit into the bounds, "
                    + (config.maxX() - config.minX()) + " x " + (config.maxY() - config.minY()));
        }
    }

    static void velocity(float vx, float vy) {
        magnitude("vx", vx, Tuning.MAX_SPEED);
        magnitude("vy", vy, Tuning.MAX_SPEED);
    }

    /** The same of many: (x, y, radius, mass) of each, and (vx, vy), or null. */
    static void circles(WorldConfig config, float[] circles, float[] velocities) {
        given("circles", circles);
        int count = circles.length / 4;
        length("circles", circles, 4 * count, "4 numbers a circle");
        if (velocities != null) {
            length("velocities", velocities, 2 * count, "2 numbers for each of " + count + " circles");
        }
        for (int i = 0; i < count; i += Tuning.CIRCLES_A_CALL) {
            few(config, circles, velocities, i, Math.min(count, i + Tuning.CIRCLES_A_CALL));
        }
    }

    private static void few(WorldConfig config, float[] circles, float[] velocities, int from, int end) {
        for (int i = from; i < end; i++) {
            try {
                circle(config, circles[4 * i], circles[4 * i + 1], circles[4 * i + 2], circles[4 * i + 3]);
                if (velocities != null) {
                    velocity(velocities[2 * i], velocities[2 * i + 1]);
                }
            } catch (IllegalArgumentException e) {
                throw new IllegalArgumentException("circle " + i + ": " + e.getMessage(), e);
            }
        }
    }

    private static void length(String name, float[] numbers, int wanted, String what) {
        if (numbers.length != wanted) {
            throw new IllegalArgumentException(name + ".length = " + numbers.length + ": must be " + what);
        }
    }

    static <T> T given(String name, T value) {
        if (value == null) {
            throw new IllegalArgumentException(name + " = null: must be given");
        }
        return value;
    }
}
