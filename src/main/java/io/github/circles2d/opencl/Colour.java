package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.CellGrid;

/** Host code of {@code kernels/colour.cl}: puts the contacts of a large world in an order that needs no locks. */
final class Colour {
    private final Kernel link;
    private final Kernel sort;

    Colour(Session session, Program program) {
        link = new Kernel(session, program, "c2d_colour_link");
        sort = new Kernel(session, program, "c2d_colour_sort");
    }

    void bind(State state, Contacts contacts, CellGrid cells, int group) {
        link.arguments(
                        state.circle,
                        contacts.contactPair,
                        contacts.next,
                        contacts.head,
                        contacts.status,
                        contacts.capacity(),
                        new float[] {cells.minX(), cells.minY()},
                        cells.perUnit(),
                        cells.columns(),
                        cells.rows())
                // about as many contacts as circles; the kernel goes round where there are more
                .range(Math.max(1, state.circles), group);
        sort.arguments(contacts.contactPair, contacts.next, contacts.head, contacts.status, cells.cells())
                .range(cells.cells(), group);
    }

    void run() {
        link.launch();
        sort.launch();
    }
}
