package io.github.circles2d.bench.peers;

/**
 * The scene for an engine that likes its lengths to be about one: lengths, speeds and gravity times {@code scale}, times and masses as
 * they are, so that the motion is the same. The box is from 0 to {@code scale}.
 *
 * @param x centres, scaled
 * @param radius scaled
 * @param gravity scaled, downwards
 */
public record Pile(
        float[] x, float[] y, float[] radius, float[] mass, double scale, double gravity, double restitution) {
    /** Seconds of a step. */
    public static final float STEP = 1 / 60f;

    /** Thickness of the walls, scaled: more than the fastest circle goes in a step. */
    public static final float WALL = 100;

    /** A pile whose mean radius is a half. */
    public static Pile of(
            float[] x, float[] y, float[] radius, float[] mass, double meanRadius, double gravity, double restitution) {
        double scale = 0.5 / meanRadius;
        return new Pile(
                scaled(x, scale), scaled(y, scale), scaled(radius, scale), mass, scale, gravity * scale, restitution);
    }

    private static float[] scaled(float[] values, double scale) {
        float[] scaled = new float[values.length];
        for (int i = 0; i < values.length; i++) {
            scaled[i] = (float) (values[i] * scale);
        }
        return scaled;
    }

    public int count() {
        return x.length;
    }

    /**
     * Centres and half extents of floor, ceiling and the two walls: rows of (x, y, half width, half height).
     */
    public float[][] walls() {
        float side = (float) scale;
        float half = side / 2;
        float thick = WALL / 2;
        return new float[][] {
            {half, -thick, half + WALL, thick},
            {half, side + thick, half + WALL, thick},
            {-thick, half, thick, half + WALL},
            {side + thick, half, thick, half + WALL}
        };
    }

    /**
     * The speed below which nothing bounces, scaled: what gravity adds in four steps. The engines' own, 1 a second, is less than a
     * circle at rest on the floor gains in one.
     */
    public double restingSpeed() {
        return 4 * gravity * STEP;
    }
}
