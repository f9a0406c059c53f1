package io.github.circles2d.opencl;

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
        Object[] known = world.known();
        grid.range(1, world.oneGroup()).arguments(known, world.levels().cells, new Kernel.Local(4L * grid.group()));
        batch.range(1, world.oneGroup())
                .arguments(
                        known,
                        new Kernel.Local(Batch.COUNTS),
                        Batch.local(contacts(world.circles()), world.circles(), false));
        solve.range(1, world.oneGroup()).arguments(known, new Kernel.Local(32L * Math.max(1, world.circles())));
    }

    /** Contacts for which there is local memory; with more it takes longer. */
    private static int contacts(int circles) {
        return 5 * circles / 2;
    }

    /** Local memory that the kernels need at most, which is what {@code c2d_alone_batch} does. */
    static long localBytes(int circles) {
        long bytes = Batch.COUNTS;
        for (Object argument : Batch.local(contacts(circles), circles, false)) {
            bytes += argument instanceof Kernel.Local memory ? memory.bytes() : 0;
        }
        return bytes;
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
