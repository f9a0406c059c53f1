package io.github.circles2d.opencl;

/** Host code of {@code kernels/alone.cl}: stages of a small world by one work-group. */
final class Alone {
    /** What is published: {@code C2D_NOTHING_YET} and so on. */
    private static final int NOTHING_YET = 0;

    private static final int STEP = 1;
    private static final int STEP_ON = 2;

    private final Kernel grid;
    private final Kernel batch;
    private final Kernel solve;
    private final Kernel solveLast;
    private final Kernel solveOn;

    Alone(Session session, Program program) {
        grid = new Kernel(session, program, "c2d_alone_grid");
        batch = new Kernel(session, program, "c2d_alone_batch");
        solve = new Kernel(session, program, "c2d_alone_solve");
        solveLast = new Kernel(session, program, "c2d_alone_solve");
        solveOn = new Kernel(session, program, "c2d_alone_solve");
    }

    void bind(SmallWorld world) {
        Object[] known = world.known();
        grid.range(1, world.oneGroup()).arguments(known, world.levels().cells, new Kernel.Local(4L * grid.group()));
        batch.range(1, world.oneGroup()).arguments(known, new Kernel.Local(Batch.COUNTS), colours(world));
        bind(solve, world, NOTHING_YET);
        bind(solveLast, world, STEP);
        bind(solveOn, world, STEP_ON);
    }

    private static void bind(Kernel kernel, SmallWorld world, int publishes) {
        State state = world.state();
        kernel.range(1, world.oneGroup())
                .arguments(
                        world.known(),
                        publishes,
                        state.circle,
                        state.velocities,
                        new Kernel.Local(bodies(world)),
                        new Kernel.Local(Integrate.MOST_BYTES));
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
        return Math.max(bytes, bodies(world) + Integrate.MOST_BYTES);
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

    /** Substeps, the end of the last included. */
    void solve(int substeps) {
        solve.more(substeps);
        solve.launch();
    }

    /** The same, of a step the last of them, which {@code lists} contacts or goes on with those listed. */
    void solveLast(int substeps, boolean lists) {
        Kernel last = lists ? solveLast : solveOn;
        last.more(substeps);
        last.launch();
    }
}
