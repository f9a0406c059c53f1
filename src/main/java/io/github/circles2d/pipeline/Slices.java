package io.github.circles2d.pipeline;

import io.github.circles2d.IndexStrategy;

/**
 * The pairs of a world cut into slices, each small enough for one buffer.
 *
 * @param circles number of circles the pairs are of; -1 for {@link #NONE}
 * @param most pairs of every slice but the last
 * @param count number of slices
 */
public record Slices(int circles, long most, int count) {
    /** Before the first circle. */
    public static final Slices NONE = new Slices(-1, 1, 0);

    /** Slices of at most {@code most} pairs. */
    public static Slices of(int circles, long most) {
        long pairs = IndexStrategy.pairs(circles);
        return new Slices(circles, most, Math.toIntExact(pairs / most + (pairs % most > 0 ? 1 : 0)));
    }

    /**
     * Slices that suit a device: one for all pairs, unless a look-up table or the triangle grows with them.
     *
     * @param maxBuffer largest buffer of the device, bytes
     * @param triangle whether each slice also has its part of the triangle
     */
    public static Slices of(WorldConfig config, int circles, long maxBuffer, boolean triangle) {
        if (circles < 2 || config.pairsPerSlice() > 0) {
            return of(circles, Math.max(1, config.pairsPerSlice()));
        }
        long table =
                config.strategy().tableBytes(circles, 2) - config.strategy().tableBytes(circles, 1);
        if (table == 0 && !triangle) {
            return of(circles, Long.MAX_VALUE);
        }
        long bytes = Math.min(table > 0 ? Tuning.TABLE_BYTES : Tuning.TRIANGLE_BYTES, maxBuffer);
        return of(circles, Math.max(1, bytes / Math.max(table, triangle ? 8 : 0)));
    }

    /** First pair of a slice. */
    public long first(int slice) {
        return slice * most;
    }

    /** Number of pairs of a slice. */
    public long pairs(int slice) {
        return Math.min(most, IndexStrategy.pairs(circles) - first(slice));
    }
}
