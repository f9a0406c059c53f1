package io.github.circles2d;

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

    static <T> T given(String name, T value) {
        if (value == null) {
            throw new IllegalArgumentException(name + " = null: must be given");
        }
        return value;
    }
}
