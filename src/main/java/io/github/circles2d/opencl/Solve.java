package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.Tuning;
import java.util.ArrayList;
import java.util.List;

/** Host code of {@code kernels/solve.cl}: a pass over the contacts, a tiling at a time, in the order of {@link Tiles}. */
final class Solve {
    /** {@code C2D_LANES}. */
    private static final int CROSSING_LANES = 48;

    private final Session session;
    private final Program program;
    /** The first tiling, where a substep comes before and where none does; the others. */
    private final Kernel moveAndFirst;

    private final Kernel kickAndFirst;
    private final List<Kernel> others = new ArrayList<>();
    private final Kernel rescale;
    private int count;
    private boolean mayCross;
    private boolean crossing;

    Solve(Session session, Program program) {
        this.session = session;
        this.program = program;
        moveAndFirst = new Kernel(session, program, "c2d_solve_first");
        kickAndFirst = new Kernel(session, program, "c2d_solve_first");
        rescale = new Kernel(session, program, "c2d_rescale");
    }

    void bind(SmallWorld world) {
        bindFirst(moveAndFirst, world, 1);
        bindFirst(kickAndFirst, world, 0);
        rescale.arguments(world.known()).range(Math.max(1, world.circles()), world.group());
        count = world.tiles().tilings - 1;
        for (int k = 0; k < count; k++) {
            if (k == others.size()) {
                others.add(new Kernel(session, program, "c2d_solve"));
            }
            bind(others.get(k), world, k + 1);
        }
        mayCross = world.tiles().crossing() && world.asOnGpu();
        crossing = !mayCross;
        crossing(mayCross);
    }

    private static void bindFirst(Kernel kernel, SmallWorld world, int move) {
        kernel.arguments(
                        world.known(),
                        move,
                        new Kernel.Local(32L * Tuning.TILE_CIRCLES),
                        new Kernel.Local(4L * Tuning.TILE_CIRCLES))
                .groups(world.tiles().count(0), world.firstTileGroup());
    }

    private static void bind(Kernel kernel, SmallWorld world, int tiling) {
        Tiles tiles = world.tiles();
        int lanes = tiling == 1 && tiles.crossing() && world.asOnGpu() ? CROSSING_LANES : 1;
        kernel.arguments(
                        world.known(),
                        tiling,
                        tiles.first(tiling),
                        new Kernel.Local(72L * lanes),
                        new Kernel.Local(12L * lanes + 4))
                .groups(tiles.count(tiling), world.tileGroup());
    }

    /** Whether crossing contacts are done with the second tiling: {@code kernels/crossing.cl}. */
    private void crossing(boolean now) {
        if (now != crossing) {
            crossing = now;
            moveAndFirst.more(now ? 1 : 0);
            kickAndFirst.more(now ? 1 : 0);
            others.forEach(kernel -> kernel.more(now ? 1 : 0));
        }
    }

    /** As {@link io.github.circles2d.pipeline.SmallStages#begin} says. */
    void rescale() {
        rescale.launch();
    }

    /**
     * Substeps, as {@link io.github.circles2d.pipeline.SmallStages#solve} says.
     *
     * @param groups for so many tiles of a tiling
     * @param crowded whether crossing contacts are too many to be done with the second tiling
     */
    void run(int substeps, int groups, boolean crowded) {
        crossing(mayCross && !crowded);
        for (int substep = 0; substep < substeps; substep++) {
            (substep > 0 ? moveAndFirst : kickAndFirst).launch(groups);
            for (int k = crossing ? 0 : count - 1; k >= 0; k--) {
                others.get(k).launch(groups);
            }
        }
    }
}
