package io.github.circles2d.pipeline;

import java.util.BitSet;

/**
 * Which circles the host has changed since the last step, {@link Tuning#CHANGED_TOGETHER} at a time. Allocates only
 * where a world grows. Not thread-safe.
 */
public final class Changes {
    private final BitSet changed = new BitSet();
    private int circles;
    private int apart;
    private int from;
    private int end;

    /** A circle has changed. */
    public void add(int circle) {
        changed.set(circle / Tuning.CHANGED_TOGETHER);
    }

    /** A step has them all. */
    public void clear() {
        changed.clear();
    }

    /**
     * {@link #next} begins with the first run.
     *
     * @param count circles of the world
     * @param most how many that have not changed may be between others of one run
     */
    public void rewind(int count, int most) {
        circles = count;
        apart = most / Tuning.CHANGED_TOGETHER;
        from = 0;
        end = 0;
    }

    /** Goes on to the next run; whether there is one. There may be circles in it that have not changed. */
    public boolean next() {
        int lot = changed.nextSetBit((end + Tuning.CHANGED_TOGETHER - 1) / Tuning.CHANGED_TOGETHER);
        if (lot < 0 || (long) lot * Tuning.CHANGED_TOGETHER >= circles) {
            return false;
        }
        from = lot * Tuning.CHANGED_TOGETHER;
        int after;
        do {
            after = changed.nextClearBit(lot);
            lot = changed.nextSetBit(after);
        } while (lot >= 0 && lot - after <= apart);
        end = (int) Math.min(circles, (long) after * Tuning.CHANGED_TOGETHER);
        return true;
    }

    /** The first circle of the run. */
    public int from() {
        return from;
    }

    /** The first circle after it. */
    public int end() {
        return end;
    }
}
