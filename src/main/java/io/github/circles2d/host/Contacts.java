package io.github.circles2d.host;

import io.github.circles2d.CapacityException;
import io.github.circles2d.pipeline.Tuning;
import java.util.Arrays;

/** The contacts of a step: the buffers {@code contactPair}, {@code contactTranslation}, {@code next}, {@code head}. */
final class Contacts {
    /** End of a list; {@code C2D_NONE}. */
    static final int NONE = -1;

    private static final int MOST = (Integer.MAX_VALUE - 64) / 2;

    int count;
    /** (i, j) a contact, i < j. */
    int[] pair = {};
    /** (x, y) a contact, from i to j, world units. */
    float[] translation = {};
    /** The contact after this one in the list of its cell. */
    int[] next = {};
    /** First contact of each cell. */
    int[] head = {};

    /** {@code c2d_append}; here the room grows at once. */
    void append(int i, int j, float x, float y) {
        if (count == next.length) {
            grow();
        }
        pair[2 * count] = i;
        pair[2 * count + 1] = j;
        translation[2 * count] = x;
        translation[2 * count + 1] = y;
        count++;
    }

    private void grow() {
        if (count == MOST) {
            throw new CapacityException(
                    "a step found more than " + MOST + " contacts; plain Java has no room for more");
        }
        int room = (int) Math.min(MOST, Math.max(Tuning.FIRST_CONTACTS, count * Tuning.GROWTH));
        pair = Arrays.copyOf(pair, 2 * room);
        translation = Arrays.copyOf(translation, 2 * room);
        next = Arrays.copyOf(next, room);
    }
}
