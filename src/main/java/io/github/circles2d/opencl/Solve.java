package io.github.circles2d.opencl;

import java.util.ArrayList;
import java.util.List;

/** Host code of {@code kernels/solve.cl}: substeps, a tiling at a time, or a small world in one launch. */
final class Solve {
    private final Session session;
    private final Program program;
    private final Kernel small;
    /** The first tiling, where a substep comes before and where none does. */
    private final Kernel firstMoves;

    private final Kernel first;
    private final List<Kernel> others = new ArrayList<>();
    private boolean merged;
    private int tilings;
    private int smallSubsteps;

    Solve(Session session, Program program) {
        this.session = session;
        this.program = program;
        small = new Kernel(session, program, "c2d_solve_small");
        firstMoves = new Kernel(session, program, "c2d_solve_first");
        first = new Kernel(session, program, "c2d_solve_first");
    }

    void bind(SmallWorld world) {
        SmallBuffers buffers = world.buffers();
        Turn now = world.now();
        Turn free = world.before();
        Object[] known = {
            now.body,
            now.id,
            buffers.kicked,
            buffers.walls,
            buffers.rule,
            now.memory,
            free.memory,
            buffers.capacity(),
            free.body,
            buffers.tileStart,
            buffers.tileColours,
            world.state().status
        };
        merged = world.merged();
        tilings = world.tiles().tilings;
        small.arguments(known, world.circles(), tilings).groups(1, world.itemsOfTile());
        smallSubsteps = 0;
        firstMoves
                .arguments(known, free.id, world.tiles().tiles, 1)
                .groups(world.tilesOf(0), world.itemsOfTile());
        first.arguments(known, free.id, world.tiles().tiles, 0).groups(world.tilesOf(0), world.itemsOfTile());
        for (int tiling = 1; tiling < tilings; tiling++) {
            if (tiling > others.size()) {
                others.add(new Kernel(session, program, "c2d_solve"));
            }
            others.get(tiling - 1)
                    .arguments(known, world.firstTile(tiling))
                    .groups(world.tilesOf(tiling), world.itemsOfTile());
        }
    }

    void run(int substeps) {
        if (merged) {
            if (substeps != smallSubsteps) {
                small.more(substeps);
                smallSubsteps = substeps;
            }
            small.launch();
            return;
        }
        for (int substep = 0; substep < substeps; substep++) {
            (substep > 0 ? firstMoves : first).launch();
            for (int tiling = 1; tiling < tilings; tiling++) {
                others.get(tiling - 1).launch();
            }
        }
    }
}
