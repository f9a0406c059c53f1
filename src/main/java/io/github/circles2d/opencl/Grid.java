package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.WorldConfig;

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

    void bind(
            WorldConfig config,
            State state,
            SmallBuffers buffers,
            Turn now,
            Turn before,
            Levels levels,
            int group,
            int oneGroup) {
        clear.arguments(buffers.bucketStart, now.ownerStart, state.status, levels.cells)
                .range(levels.cells + 1, group);
        bin.arguments(
                        before.body,
                        before.id,
                        buffers.levelOf,
                        now.levels,
                        now.cell,
                        buffers.bucket,
                        buffers.bucketStart,
                        state.status,
                        buffers.rule,
                        state.circles,
                        levels.perUnit,
                        levels.lastColumn(config),
                        levels.lastRow(config))
                .range(state.circles, group);
        scan.bind(buffers.bucketStart, levels.cells + 1, state, buffers, group, oneGroup);
        scatter.arguments(buffers.bucket, buffers.bucketStart, state.status, state.circles, buffers.unsorted)
                .range(state.circles, group);
        order.arguments(
                        buffers.unsorted,
                        buffers.bucket,
                        buffers.bucketStart,
                        before.body,
                        before.id,
                        state.status,
                        state.circles,
                        now.body,
                        now.id)
                .range(state.circles, group);
    }

    void run() {
        clear.launch();
        bin.launch();
        scan.run();
        scatter.launch();
        order.launch();
    }
}
