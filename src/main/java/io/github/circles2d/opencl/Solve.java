package io.github.circles2d.opencl;

import java.util.ArrayList;
import java.util.List;

/** Host code of {@code kernels/solve.cl}: substeps, a tiling at a time. */
final class Solve {
    private final Session session;
    private final Program program;
    /** The first tiling, where a substep comes before and where none does. */
    private final Kernel firstMoves;

    private final Kernel first;
    private final List<Kernel> others = new ArrayList<>();
    private int tilings;

    Solve(Session session, Program program) {
        this.session = session;
        this.program = program;
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
        tilings = world.tiles().tilings;
        firstMoves
                .arguments(known, free.id, world.tiles().tiles, 1)
                .groups(world.tiles().count(0), world.tileGroup());
        first.arguments(known, free.id, world.tiles().tiles, 0).groups(world.tiles().count(0), world.tileGroup());
        for (int tiling = 1; tiling < tilings; tiling++) {
            if (tiling > others.size()) {
                others.add(new Kernel(session, program, "c2d_solve"));
            }
            others.get(tiling - 1)
                    .arguments(known, world.tiles().first(tiling))
                    .groups(world.tiles().count(tiling), world.tileGroup());
        }
    }

    void run(int substeps) {
        for (int substep = 0; substep < substeps; substep++) {
            (substep > 0 ? firstMoves : first).launch();
            for (int tiling = 1; tiling < tilings; tiling++) {
                others.get(tiling - 1).launch();
            }
        }
    }
}
