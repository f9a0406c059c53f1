package io.github.circles2d.pipeline;

import java.util.BitSet;

/**
 * Which circles the host has changed since the last step, {@link Tuning#CHANGED_TOGETHER} at a time. Allocates only
 * where a world grows. Not thread-safe.
 */
public final class Changes {
    private final BitSet changed = new BitSet();
    /** Those of which some were set going. */
    private final BitSet moving = new BitSet();
    /** Which of the two {@link #next} goes through. */
    private BitSet those = changed;

    private int circles;
    private int apart;
    private int from;
    private int end;

    /** A circle has changed, and may move. */
    public void add(int circle) {
        add(circle, true);
    }

    /** A circle has changed, and {@code moves} or rests: a new world of a million at rest need not be looked through for the fastest. */
    public void add(int circle, boolean moves) {
        changed.set(circle / Tuning.CHANGED_TOGETHER);
        if (moves) {
            moving.set(circle / Tuning.CHANGED_TOGETHER);
        }
    }

    /** Circles {@code from} to {@code end} - 1 have changed, and may {@code move} or rest. */
    public void add(int from, int end, boolean move) {
        if (from < end) {
            int after = (end - 1) / Tuning.CHANGED_TOGETHER + 1;
            changed.set(from / Tuning.CHANGED_TOGETHER, after);
            if (move) {
                moving.set(from / Tuning.CHANGED_TOGETHER, after);
            }
        }
    }

    /** A step has them all. */
    public void clear() {
        changed.clear();
        moving.clear();
    }

    /**
     * {@link #next} begins with the first run.
     *
     * @param count circles of the world
     * @param most how many that have not changed may be between others of one run
     */
    public void rewind(int count, int most) {
        rewind(changed, count, most);
    }

    /** The same of those among which some have changed that move. */
    public void rewindMoving(int count) {
        rewind(moving, count, 0);
    }

    private void rewind(BitSet lots, int count, int most) {
        those = lots;
        circles = count;
        apart = most / Tuning.CHANGED_TOGETHER;
        from = 0;
        end = 0;
    }

    /** Goes on to the next run; whether there is one. There may be circles in it that have not changed. */
    public boolean next() {
        int lot = those.nextSetBit((end + Tuning.CHANGED_TOGETHER - 1) / Tuning.CHANGED_TOGETHER);
        if (lot < 0 || (long) lot * Tuning.CHANGED_TOGETHER >= circles) {
            return false;
        }
        from = lot * Tuning.CHANGED_TOGETHER;
        int after;
        do {
            after = those.nextClearBit(lot);
            lot = those.nextSetBit(after);
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
