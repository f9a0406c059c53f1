package io.github.circles2d.host;

import io.github.circles2d.CapacityException;
import io.github.circles2d.pipeline.Tuning;
import java.util.Arrays;

/**
 * The lists of contacts of {@link io.github.circles2d.Solver#SMALL_STEPS}, of this detection and of the one before: the
 * buffers of {@code kernels/small.cl}, by the same names.
 */
final class SmallContacts {
    private static final int MOST = (Integer.MAX_VALUE - 64) / 4;

    /** Contacts as they are found, by one thread. */
    static final class Found {
        int count;
        /** The circle that a contact is not listed with. */
        int[] other = {};
        /** The one it is listed with; only where that does not follow from the order. */
        int[] lists = {};

        void append(int circle, int listedWith) {
            if (count == other.length) {
                if (count == MOST) {
                    throw new CapacityException(
                            "a step found more than " + MOST + " contacts; Java has room for no more");
                }
                int room = (int) Math.min(MOST, Math.max(Tuning.FIRST_CONTACTS, count * Tuning.GROWTH));
                other = Arrays.copyOf(other, room);
                lists = Arrays.copyOf(lists, room);
            }
            other[count] = circle;
            lists[count] = listedWith;
            count++;
        }
    }

    /** Where the list of each circle begins; one more for the end of the last. */
    int[] listStart = {0};

    int[] listStartBefore = {0};
    /** The place of the other circle. */
    int[] other = {};

    int[] otherBefore = {};
    /** Where in the order of solving each contact is. */
    int[] where = {};

    int[] whereBefore = {};
    /** In the order of solving: the impulse to come, and the last one; -1 after a bounce. */
    float[] memory = {};

    float[] memoryBefore = {};

    /** Makes room for more circles, whose lists are empty. */
    void ensureCircles(int room) {
        if (listStart.length < room + 1) {
            int old = listStart.length;
            listStart = Arrays.copyOf(listStart, room + 1);
            Arrays.fill(listStart, old, room + 1, listStart[old - 1]);
            listStartBefore = new int[room + 1];
        }
    }

    /** What was this detection is now the one before. */
    void turn() {
        int[] swap = listStart;
        listStart = listStartBefore;
        listStartBefore = swap;
        swap = other;
        other = otherBefore;
        otherBefore = swap;
        swap = where;
        where = whereBefore;
        whereBefore = swap;
        float[] swapMemory = memory;
        memory = memoryBefore;
        memoryBefore = swapMemory;
    }

    /** Turns the lengths of the lists, each one place up, into where they begin, and makes room for them. */
    void lay(int circles) {
        long all = 0;
        for (int i = 1; i <= circles; i++) {
            all += listStart[i];
            if (all > MOST) {
                throw new CapacityException("a step found more than " + MOST + " contacts; Java has room for no more");
            }
            listStart[i] = (int) all;
        }
        // new circles, until the next detection, have empty lists
        Arrays.fill(listStart, circles + 1, listStart.length, (int) all);
        if (other.length < all) {
            int room = (int) Math.min(MOST, Math.max(Tuning.FIRST_CONTACTS, all * Tuning.GROWTH));
            other = new int[room];
            where = new int[room];
            memory = new float[2 * room];
        }
    }
}
