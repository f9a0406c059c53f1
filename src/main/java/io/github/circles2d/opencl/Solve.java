package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.Tuning;
import java.util.ArrayList;
import java.util.List;

/** Host code of {@code kernels/solve.cl}: a pass over the contacts, a tiling at a time. */
final class Solve {
    /** What comes before a tiling: {@code C2D_NOTHING} and so on. */
    private static final int NOTHING = 0;

    private static final int KICK = 1;
    private static final int MOVE_AND_KICK = 2;
    private static final int KICK_ON = 3;

    private final Session session;
    private final Program program;
    /** The first tiling, where no substep comes before; where one does, by turns there and back; the others. */
    private final Kernel kickAndFirst;

    private final Kernel kickOnAndFirst;
    private final Kernel moveAndFirst;
    private final Kernel moveAndFirstBack;
    private final List<Kernel> others = new ArrayList<>();
    private final Kernel rescale;
    private int count;

    Solve(Session session, Program program) {
        this.session = session;
        this.program = program;
        kickAndFirst = new Kernel(session, program, "c2d_solve");
        kickOnAndFirst = new Kernel(session, program, "c2d_solve");
        moveAndFirst = new Kernel(session, program, "c2d_solve");
        moveAndFirstBack = new Kernel(session, program, "c2d_solve");
        rescale = new Kernel(session, program, "c2d_rescale");
    }

    void bind(SmallWorld world) {
        bind(kickAndFirst, world, 0, KICK, false);
        bind(kickOnAndFirst, world, 0, KICK_ON, false);
        bind(moveAndFirst, world, 0, MOVE_AND_KICK, false);
        bind(moveAndFirstBack, world, 0, MOVE_AND_KICK, true);
        rescale.arguments(world.known()).range(Math.max(1, world.circles()), world.group());
        count = world.tiles().tilings - 1;
        for (int k = 0; k < count; k++) {
            if (k == others.size()) {
                others.add(new Kernel(session, program, "c2d_solve"));
            }
            bind(others.get(k), world, k + 1, NOTHING, false);
        }
    }

    private static void bind(Kernel kernel, SmallWorld world, int tiling, int begins, boolean backwards) {
        Tiles tiles = world.tiles();
        boolean local = begins != NOTHING;
        int circles = local ? Tuning.TILE_CIRCLES : 1;
        kernel.arguments(
                        world.known(),
                        tiling,
                        tiles.first(tiling),
                        begins,
                        backwards ? 1 : 0,
                        new Kernel.Local(32L * circles),
                        new Kernel.Local(4L * circles))
                .groups(tiles.count(tiling), local ? world.firstTileGroup() : world.tileGroup());
    }

    /** As {@link io.github.circles2d.pipeline.SmallStages#begin} says. */
    void rescale() {
        rescale.launch();
    }

    /**
     * Substeps, as {@link io.github.circles2d.pipeline.SmallStages#solve} says.
     *
     * @param groups for so many tiles of a tiling
     * @param lists whether there is a detection in the step
     */
    void run(int substeps, int groups, boolean lists) {
        Kernel kick = lists ? kickAndFirst : kickOnAndFirst;
        for (int substep = 0; substep < substeps; substep++) {
            Kernel move = substep % 2 == 0 ? moveAndFirst : moveAndFirstBack;
            (substep == 0 ? kick : move).launch(groups);
            for (int k = 0; k < count; k++) {
                others.get(k).launch(groups);
            }
        }
    }
}
