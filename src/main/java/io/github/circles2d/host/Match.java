package io.github.circles2d.host;

import io.github.circles2d.pipeline.Levels;

/**
 * Twin of {@code kernels/match.cl}: sorts the contacts by owner and numbers, and gives each what the detection before
 * remembers of it.
 */
final class Match {
    private final SmallState state;
    private final SmallContacts contacts;

    private final Workers workers;
    private final Workers.Work work = this::part;

    Match(SmallState state, SmallContacts contacts, Workers workers) {
        this.state = state;
        this.contacts = contacts;
        this.workers = workers;
    }

    void run() {
        contacts.matchRoom();
        int[] start = contacts.ownerStart;
        int owners = state.levels.cells;
        for (SmallContacts.Found found : contacts.found) {
            for (int k = 0; k < found.count; k++) {
                start[found.owner[k]]++;
            }
        }
        for (int owner = 1; owner <= owners; owner++) {
            start[owner] += start[owner - 1];
        }
        // each takes the last free place of its owner, which leaves the start at the first
        for (SmallContacts.Found found : contacts.found) {
            for (int k = 0; k < found.count; k++) {
                int to = --start[found.owner[k]];
                contacts.pair[2 * to] = found.pair[2 * k];
                contacts.pair[2 * to + 1] = found.pair[2 * k + 1];
            }
        }
        workers.run(contacts.count, work);
        state.levelsBefore = state.levels;
    }

    private void part(int part, int from, int end) {
        int owners = state.levels.cells;
        int owner = contacts.ownerFrom(from, 0, owners);
        int last = contacts.ownerFrom(end, 0, owners);
        int first = contacts.ownerStart[owner];
        for (; owner < last; owner++) {
            sort(contacts.ownerStart[owner], contacts.ownerStart[owner + 1]);
        }
        for (int k = first; k < contacts.ownerStart[last]; k++) {
            remember(k);
        }
    }

    /** By the numbers of the circles; lists are short. */
    private void sort(int from, int end) {
        int[] pair = contacts.pair;
        for (int k = from + 1; k < end; k++) {
            int a = pair[2 * k];
            int b = pair[2 * k + 1];
            int to = k;
            while (to > from && before(a, b, pair[2 * to - 2], pair[2 * to - 1])) {
                pair[2 * to] = pair[2 * to - 2];
                pair[2 * to + 1] = pair[2 * to - 1];
                to--;
            }
            pair[2 * to] = a;
            pair[2 * to + 1] = b;
        }
    }

    private boolean before(int a, int b, int otherA, int otherB) {
        int[] id = state.id;
        return id[a] < id[otherA] || id[a] == id[otherA] && id[b] < id[otherB];
    }

    private void remember(int k) {
        int a = state.id[contacts.pair[2 * k]];
        int b = state.id[contacts.pair[2 * k + 1]];
        int old = find(a, b);
        contacts.ids[2 * k] = a;
        contacts.ids[2 * k + 1] = b;
        contacts.memory[2 * k] = old < 0 ? 0 : contacts.memoryBefore[2 * old];
        contacts.memory[2 * k + 1] = old < 0 ? 0 : contacts.memoryBefore[2 * old + 1];
    }

    /** The contact of two circles at the detection before, or -1: its owner follows from their cells. */
    private int find(int a, int b) {
        int[] cell = state.cellBefore;
        int ca = SmallState.CELL * a;
        int cb = SmallState.CELL * b;
        if (cell[ca + 2] < 0 || cell[cb + 2] < 0) {
            return -1;
        }
        Levels levels = state.levelsBefore;
        int at = Levels.INTS * Math.max(cell[ca + 2], cell[cb + 2]);
        int shift = levels.table[at + Levels.SHIFT];
        int ax = cell[ca] >> shift;
        int ay = cell[ca + 1] >> shift;
        int bx = cell[cb] >> shift;
        int by = cell[cb + 1] >> shift;
        if (Math.abs(ax - bx) > 1 || Math.abs(ay - by) > 1) {
            return -1;
        }
        boolean lower = ay < by || ay == by && ax <= bx;
        int owner = lower ? levels.owner(at, ax, ay) : levels.owner(at, bx, by);
        int low = contacts.ownerStartBefore[owner];
        int end = contacts.ownerStartBefore[owner + 1];
        int high = end;
        int[] ids = contacts.idsBefore;
        while (low < high) {
            int middle = low + (high - low) / 2;
            if (ids[2 * middle] < a || ids[2 * middle] == a && ids[2 * middle + 1] < b) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low < end && ids[2 * low] == a && ids[2 * low + 1] == b ? low : -1;
    }
}
