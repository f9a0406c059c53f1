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
        batch.range(1, world.oneGroup()).arguments(known, new Kernel.Local(Batch.COUNTS), colours(world));
        solve.range(1, world.oneGroup()).arguments(known, new Kernel.Local(bodies(world)));
    }

    /** The local memory of colours, on a GPU for two and a half contacts a circle: with more of them it takes longer. */
    private static Object[] colours(SmallWorld world) {
        return world.asOnGpu()
                ? Batch.local(5 * world.circles() / 2, world.circles(), false)
                : Batch.local(0, 0, false);
    }

    /** Local memory that the kernels need at most. */
    static long localBytes(SmallWorld world) {
        long bytes = Batch.COUNTS;
        for (Object argument : colours(world)) {
            bytes += argument instanceof Kernel.Local memory ? memory.bytes() : 0;
        }
        return Math.max(bytes, bodies(world));
    }

    private static long bodies(SmallWorld world) {
        return 32L * Math.max(1, world.circles());
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
