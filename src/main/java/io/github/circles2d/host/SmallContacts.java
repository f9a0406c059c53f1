package io.github.circles2d.host;

import io.github.circles2d.CapacityException;
import io.github.circles2d.pipeline.Tuning;
import java.util.Arrays;

/** The contacts of {@link io.github.circles2d.Solver#SMALL_STEPS}, of this detection and what is kept of the one before. */
final class SmallContacts {
    private static final int MOST = (Integer.MAX_VALUE - 64) / 4;

    int count;
    /** As found: places of the two circles in the order of the cells, lower number first. */
    int[] found = {};
    /** As found: the owner. */
    int[] foundOwner = {};

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
        count = 0;
    }

    void append(int a, int b, int owner) {
        if (count == foundOwner.length) {
            if (count == MOST) {
                throw new CapacityException("a step found more than " + MOST + " contacts; Java has room for no more");
            }
            int room = (int) Math.min(MOST, Math.max(Tuning.FIRST_CONTACTS, count * Tuning.GROWTH));
            found = Arrays.copyOf(found, 2 * room);
            foundOwner = Arrays.copyOf(foundOwner, room);
        }
        found[2 * count] = a;
        found[2 * count + 1] = b;
        foundOwner[count] = owner;
        ownerStart[owner]++;
        count++;
    }

    /** Makes the sorted lists as large as what was found. */
    void matchRoom() {
        if (pair.length < found.length) {
            pair = new int[found.length];
        }
        if (ids.length < found.length) {
            ids = new int[found.length];
            memory = new float[found.length];
        }
    }
}
