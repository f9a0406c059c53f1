package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.CellGrid;

/** Host code of {@code kernels/colour.cl}: puts the contacts of a large world in an order that needs no locks. */
final class Colour {
    private final Kernel count;
    private final Kernel scan;
    private final Kernel scatter;
    private final Kernel rank;

    Colour(Session session, Program program) {
        count = new Kernel(session, program, "c2d_colour_count");
        scan = new Kernel(session, program, "c2d_colour_scan");
        scatter = new Kernel(session, program, "c2d_colour_scatter");
        rank = new Kernel(session, program, "c2d_colour_rank");
    }

    void bind(State state, Contacts contacts, CellGrid cells, float restitution, int group, int oneGroup) {
        Object[] grid = {
            state.circle, new float[] {cells.minX(), cells.minY()}, cells.perUnit(), cells.columns(), cells.rows()
        };
        // about as many contacts as circles; the kernels go round where there are more
        long items = Math.max(1, state.circles);
        count.arguments(grid, contacts.found, contacts.cellStart, state.status, contacts.capacity())
                .range(items, group);
        scan.arguments(contacts.cellStart, state.status, cells.cells(), new Kernel.Local(4L * oneGroup))
                .range(1, oneGroup);
        scatter.arguments(grid, contacts.found, contacts.cellStart, state.status, contacts.byCell)
                .range(items, group);
        rank.arguments(grid, contacts.byCell, contacts.cellStart, state.status, restitution, contacts.contact)
                .range(items, group);
    }

    void run() {
        count.launch();
        scan.launch();
        scatter.launch();
        rank.launch();
    }
}
