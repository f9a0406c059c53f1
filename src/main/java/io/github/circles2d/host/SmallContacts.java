package io.github.circles2d.host;

import io.github.circles2d.CapacityException;
import io.github.circles2d.pipeline.Tuning;
import java.util.Arrays;

/** The contacts of {@link io.github.circles2d.Solver#SMALL_STEPS}, of this detection and what is kept of the one before. */
final class SmallContacts {
    private static final int MOST = (Integer.MAX_VALUE - 64) / 4;

    /** Contacts as they are found, by one thread. */
    static final class Found {
        int count;
        /** Places of the two circles in the order of the cells, lower number first. */
        int[] pair = {};

        int[] owner = {};

        void append(int a, int b, int to) {
            if (count == owner.length) {
                if (count == MOST) {
                    throw new CapacityException(
                            "a step found more than " + MOST + " contacts; Java has room for no more");
                }
                int room = (int) Math.min(MOST, Math.max(Tuning.FIRST_CONTACTS, count * Tuning.GROWTH));
                pair = Arrays.copyOf(pair, 2 * room);
                owner = Arrays.copyOf(owner, room);
            }
            pair[2 * count] = a;
            pair[2 * count + 1] = b;
            owner[count] = to;
            count++;
        }
    }

    int count;
    /** One for each part of the circles. */
    final Found[] found;

    /** Sorted by owner and numbers: the places of the two circles. */
    int[] pair = {};
    /** Sorted: the numbers of the two circles. */
    int[] ids = {};

    int[] idsBefore = {};
    /** Sorted: the impulse to come, and the last one; -1 after a bounce. */
    float[] memory = {};

    float[] memoryBefore = {};
    /** The first contact of each owner, and their number. */
    int[] ownerStart = {};

    int[] ownerStartBefore = {};

    /** @param parts parts that find may come in */
    SmallContacts(int parts) {
        found = new Found[parts];
        Arrays.setAll(found, part -> new Found());
    }

    /** What was this detection is now the one before. */
    void turn(int owners) {
        int[] swap = ids;
        ids = idsBefore;
        idsBefore = swap;
        float[] swapMemory = memory;
        memory = memoryBefore;
        memoryBefore = swapMemory;
        swap = ownerStart;
        ownerStart = ownerStartBefore;
        ownerStartBefore = swap;
        if (ownerStart.length < owners + 1) {
            ownerStart = new int[owners + 1];
        } else {
            Arrays.fill(ownerStart, 0, owners + 1, 0);
        }
        for (Found part : found) {
            part.count = 0;
        }
    }

    /** Counts what was found and makes the sorted lists large enough for it. */
    void matchRoom() {
        long all = 0;
        for (Found part : found) {
            all += part.count;
        }
        if (all > MOST) {
            throw new CapacityException("a step found " + all + " contacts; Java has room for " + MOST);
        }
        count = (int) all;
        int room = (int) Math.min(MOST, Math.max(Tuning.FIRST_CONTACTS, count * Tuning.GROWTH));
        if (pair.length < 2 * count) {
            pair = new int[2 * room];
        }
        if (ids.length < 2 * count) {
            ids = new int[2 * room];
            memory = new float[2 * room];
        }
    }

    /** The first of the owners {@code low .. high} whose contacts begin at contact k or later. */
    int ownerFrom(int k, int low, int high) {
        int from = low;
        int end = high;
        while (from < end) {
            int middle = from + (end - from) / 2;
            if (ownerStart[middle] < k) {
                from = middle + 1;
            } else {
                end = middle;
            }
        }
        return from;
    }
}
