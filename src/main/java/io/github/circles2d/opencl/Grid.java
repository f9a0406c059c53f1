package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Tiles;

/** Host code of {@code kernels/grid.cl}: sorts the circles by bucket, and by number within each. */
final class Grid {
    private final Kernel clear;
    private final Kernel bin;
    private final Scan scan;
    private final Kernel scatter;
    private final Kernel order;

    Grid(Session session, Program program) {
        clear = new Kernel(session, program, "c2d_grid_clear");
        bin = new Kernel(session, program, "c2d_grid_bin");
        scan = new Scan(session, program);
        scatter = new Kernel(session, program, "c2d_grid_scatter");
        order = new Kernel(session, program, "c2d_grid_order");
    }

    void bind(SmallWorld world) {
        Object[] known = world.known();
        int cells = world.levels().cells;
        int parts = world.tiles().parts();
        clear.arguments(known, cells, parts)
                .range(Math.max(Math.max(cells, parts) + 1L, Tiles.MOST_TILINGS), world.group());
        bin.arguments(known).range(world.circles(), world.group());
        scan.bind(world, Heap.BUCKET_START, cells + 1, false);
        scatter.arguments(known).range(world.circles(), world.group());
        order.arguments(known).range(world.circles(), world.group());
    }

    void run() {
        clear.launch();
        bin.launch();
        scan.run();
        scatter.launch();
        order.launch();
    }
}
