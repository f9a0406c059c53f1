package io.github.circles2d.host;

import java.util.SplittableRandom;

/** Twin of {@code kernels/arithmetic.cl}: the operations that the stages use, on numbers of every size. */
public final class Arithmetic {
    /** Results for each pair of operands. */
    public static final int RESULTS = 6;

    private Arithmetic() {}

    /** Operands of either sign from 2^-60 to 2^13, and a few that are subnormal; the same in every run. */
    public static float[] operands(long seed, int count) {
        SplittableRandom random = new SplittableRandom(seed);
        float[] values = new float[count];
        for (int i = 0; i < count; i++) {
            float size = i % 16 == 0 ? Float.MIN_NORMAL / 64 : Math.scalb(1f, random.nextInt(-60, 13));
            values[i] = (float) random.nextDouble(1, 2) * (random.nextBoolean() ? size : -size);
        }
        return values;
    }

    /** What the kernel computes. */
    public static float[] results(float[] a, float[] b) {
        float[] r = new float[RESULTS * a.length];
        for (int i = 0; i < a.length; i++) {
            float x = a[i];
            float y = b[i];
            r[RESULTS * i] = x + y;
            r[RESULTS * i + 1] = x * y + x;
            r[RESULTS * i + 2] = x / y;
            r[RESULTS * i + 3] = (float) Math.sqrt(x * x + y * y);
            r[RESULTS * i + 4] = 1 / y - x * x;
            r[RESULTS * i + 5] = (float) (int) (x * 16) * y;
        }
        return r;
    }
}
