package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Tiles;

/** Host code of {@code kernels/alone.cl}: stages of a small world by one work-group. */
final class Alone {
    private final Kernel grid;
    private final Kernel batch;
    private final Kernel solve;

    Alone(Session session, Program program) {
        grid = new Kernel(session, program, "c2d_alone_grid");
        batch = new Kernel(session, program, "c2d_alone_batch");
        solve = new Kernel(session, program, "c2d_alone_solve");
    }

    void bind(SmallWorld world) {
        SmallBuffers buffers = world.buffers();
        DeviceBuffer status = world.state().status;
        Turn now = world.now();
        Turn before = world.before();
        int tilings = world.tiles().tilings;
        int circles = world.circles();
        grid.range(1, world.oneGroup())
                .arguments(
                        before.body,
                        before.id,
                        buffers.levels,
                        buffers.rule,
                        status,
                        circles,
                        world.levels().cells,
                        Tiles.PARTS * tilings,
                        buffers.bucketStart,
                        buffers.tileStart,
                        buffers.kicked,
                        now.other,
                        now.body,
                        now.id,
                        buffers.from,
                        now.listStart,
                        new Kernel.Local(4L * grid.group()));
        batch.range(1, world.oneGroup())
                .arguments(
                        Batch.contacts(world, 1),
                        now.body,
                        buffers.tilings,
                        buffers.rule,
                        circles,
                        tilings,
                        buffers.tileStart,
                        before.other,
                        before.memory,
                        buffers.tileColours,
                        new Kernel.Local(Math.max(4L * batch.group(), Batch.COUNTS)));
        solve.range(1, world.oneGroup()).arguments(Solve.known(world), circles, tilings);
    }

    void grid() {
        grid.launch();
    }

    void batch() {
        batch.launch();
    }

    /** As {@link io.github.circles2d.pipeline.SmallStages#solve} says. */
    void solve(int substeps) {
        solve.more(substeps);
        solve.launch();
    }
}
