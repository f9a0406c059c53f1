package io.github.circles2d.host;

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
        if (config.triangle()) {
            detect.collect();
        }
        contacts.matchRoom();
        int[] start = contacts.cellStart;
        // counts, then the place one past the last contact of each cell
        for (int k = 0; k < contacts.count; k++) {
            start[owner(contacts.found, k, cells)]++;
        }
        for (int cell = 1; cell < cells.cells(); cell++) {
            start[cell] += start[cell - 1];
        }
        start[cells.cells()] = contacts.count;
        // each takes the last free place of its cell, which leaves the start at the first
        for (int k = 0; k < contacts.count; k++) {
            int place = --start[owner(contacts.found, k, cells)];
            System.arraycopy(contacts.found, Contacts.INTS * k, contacts.byCell, Contacts.INTS * place, Contacts.INTS);
        }
        for (int cell = 0; cell < cells.cells(); cell++) {
            for (int k = start[cell]; k < start[cell + 1]; k++) {
                rank(k, start[cell], start[cell + 1]);
            }
        }
    }

    /** The lower, by y and then by x, of the cells of the two circles. */
    private int owner(int[] contact, int k, CellGrid cells) {
        int i = contact[Contacts.INTS * k];
        int j = contact[Contacts.INTS * k + 1];
        float[] circle = state.circle;
        return Math.min(cells.cell(circle[4 * i], circle[4 * i + 1]), cells.cell(circle[4 * j], circle[4 * j + 1]));
    }

    /** Puts contact k of those sorted by cell in its place, by the numbers of its circles, in its cell. */
    private void rank(int k, int start, int end) {
        int[] byCell = contacts.byCell;
        int i = byCell[Contacts.INTS * k];
        int j = byCell[Contacts.INTS * k + 1];
        int place = start;
        for (int other = start; other < end; other++) {
            int otherI = byCell[Contacts.INTS * other];
            if (otherI < i || (otherI == i && byCell[Contacts.INTS * other + 1] < j)) {
                place++;
            }
        }
        System.arraycopy(byCell, Contacts.INTS * k, contacts.contact, Contacts.INTS * place, Contacts.INTS);
    }
}
