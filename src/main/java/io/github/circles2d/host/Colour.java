package io.github.circles2d.host;

import io.github.circles2d.CollisionStore;
import io.github.circles2d.pipeline.CellGrid;
import io.github.circles2d.pipeline.WorldConfig;

/** Twin of {@code kernels/colour.cl}: puts the contacts in an order that needs no locks. */
final class Colour {
    private final WorldConfig config;
    private final State state;
    private final Contacts contacts;
    private final Detect detect;

    Colour(WorldConfig config, State state, Contacts contacts, Detect detect) {
        this.config = config;
        this.state = state;
        this.contacts = contacts;
        this.detect = detect;
    }

    void run(CellGrid cells) {
        if (config.store() == CollisionStore.TRIANGLE) {
            detect.collect();
        }
        for (int k = 0; k < contacts.count; k++) {
            int i = contacts.pair[2 * k];
            int j = contacts.pair[2 * k + 1];
            // the lower of two cells, by y, then by x
            int owner = Math.min(
                    cells.cell(state.circle[4 * i], state.circle[4 * i + 1]),
                    cells.cell(state.circle[4 * j], state.circle[4 * j + 1]));
            contacts.next[k] = contacts.head[owner];
            contacts.head[owner] = k;
        }
        for (int cell = 0; cell < cells.cells(); cell++) {
            contacts.head[cell] = sorted(contacts.head[cell]);
        }
    }

    private boolean before(int a, int b) {
        int[] pair = contacts.pair;
        return pair[2 * a] < pair[2 * b] || (pair[2 * a] == pair[2 * b] && pair[2 * a + 1] < pair[2 * b + 1]);
    }

    /** Sorts a list of contacts by the numbers of their circles, merging runs of 1, 2, 4, ...; returns its new head. */
    private int sorted(int head) {
        int[] next = contacts.next;
        for (int run = 1; ; run *= 2) {
            int rest = head;
            int tail = Contacts.NONE;
            int merges = 0;
            while (rest != Contacts.NONE) {
                merges++;
                int left = rest;
                int right = rest;
                int lefts = 0;
                while (lefts < run && right != Contacts.NONE) {
                    right = next[right];
                    lefts++;
                }
                int rights = run;
                while (lefts > 0 || (rights > 0 && right != Contacts.NONE)) {
                    boolean fromRight = rights > 0 && right != Contacts.NONE && (lefts == 0 || before(right, left));
                    int least = fromRight ? right : left;
                    if (fromRight) {
                        right = next[right];
                        rights--;
                    } else {
                        left = next[left];
                        lefts--;
                    }
                    if (tail == Contacts.NONE) {
                        head = least;
                    } else {
                        next[tail] = least;
                    }
                    tail = least;
                }
                rest = right;
            }
            if (tail != Contacts.NONE) {
                next[tail] = Contacts.NONE;
            }
            if (merges <= 1) {
                return head;
            }
        }
    }
}
