package io.github.circles2d.host;

import io.github.circles2d.CapacityException;
import io.github.circles2d.pipeline.Tuning;
import java.util.Arrays;

/** The contacts of a step: the buffers {@code found}, {@code byCell}, {@code contact} and {@code cellStart}. */
final class Contacts {
    /** An int4 a contact: the numbers i < j of its circles, and the bits of the translation vector from i to j. */
    static final int INTS = 4;

    private static final int MOST = (Integer.MAX_VALUE - 64) / INTS;

    int count;
    /** As detect found them. */
    int[] found = {};
    /** Sorted by cell. */
    int[] byCell = {};
    /** Sorted by cell and numbers. */
    int[] contact = {};
    /** The first contact of each cell, and one past the last of all. */
    int[] cellStart = {};

    /** {@code c2d_append}; here the room grows at once. */
    void append(int i, int j, float x, float y) {
        int at = INTS * count;
        if (at == found.length) {
            if (count == MOST) {
                throw new CapacityException("a step found more than " + MOST + " contacts; Java has room for no more");
            }
            found = Arrays.copyOf(
                    found, INTS * (int) Math.min(MOST, Math.max(Tuning.FIRST_CONTACTS, count * Tuning.GROWTH)));
        }
        found[at] = i;
        found[at + 1] = j;
        found[at + 2] = Float.floatToRawIntBits(x);
        found[at + 3] = Float.floatToRawIntBits(y);
        count++;
    }

    /** Makes the sorted copies as large as what was found. */
    void matchRoom() {
        if (byCell.length < found.length) {
            byCell = new int[found.length];
            contact = new int[found.length];
        }
    }
}
