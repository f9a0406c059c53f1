package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.CellGrid;

/** Host code of {@code kernels/near.cl}: finds the circles that overlap by a grid. */
final class Near {
    private final DeviceBuffer nearStart;
    private final DeviceBuffer near;
    private final Kernel clear;
    private final Kernel count;
    private final Kernel scan;
    private final Kernel scatter;
    private final Kernel find;

    Near(Session session, Program program) {
        nearStart = new DeviceBuffer(session, "nearStart");
        near = new DeviceBuffer(session, "near");
        clear = new Kernel(session, program, "c2d_near_clear");
        count = new Kernel(session, program, "c2d_near_count");
        scan = new Kernel(session, program, "c2d_colour_scan");
        scatter = new Kernel(session, program, "c2d_near_scatter");
        find = new Kernel(session, program, "c2d_near_find");
    }

    void bind(State state, Contacts contacts, CellGrid cells, int group, int oneGroup) {
        Object[] grid = {
            state.circle,
            new float[] {cells.minX(), cells.minY()},
            cells.perUnit(),
            cells.columns(),
            cells.rows(),
            state.circles
        };
        nearStart.ensure(4L * cells.cells());
        near.ensure(4L * state.circles);
        clear.arguments(nearStart, cells.cells()).range(cells.cells(), group);
        count.arguments(grid, nearStart).range(state.circles, group);
        scan.arguments(nearStart, state.status, cells.cells(), new Kernel.Local(4L * oneGroup))
                .range(1, oneGroup);
        scatter.arguments(grid, nearStart, state.status, near).range(state.circles, group);
        find.arguments(grid, nearStart, near, contacts.found, state.status, contacts.capacity())
                .range(state.circles, group);
    }

    void run() {
        clear.launch();
        count.launch();
        scan.launch();
        scatter.launch();
        find.launch();
    }
}
