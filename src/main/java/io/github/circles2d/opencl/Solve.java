package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;
import java.util.ArrayList;
import java.util.List;

/** Host code of {@code kernels/solve.cl}: one pass over the contacts, a level and a colour at a time. */
final class Solve {
    private final Session session;
    private final Program program;
    private final List<Kernel> colours = new ArrayList<>();
    private final Kernel narrow;
    private int launches;
    private boolean narrows;

    Solve(Session session, Program program) {
        this.session = session;
        this.program = program;
        narrow = new Kernel(session, program, "c2d_solve_narrow");
    }

    void bind(WorldConfig config, State state, SmallBuffers buffers, Turn now, Levels levels, int group, int oneGroup) {
        int wide = config.smallWorld() > 0 ? wideLevels(levels) : levels.count;
        launches = Levels.COLOURS * wide;
        narrows = wide < levels.count;
        while (colours.size() < launches) {
            colours.add(new Kernel(session, program, "c2d_solve"));
        }
        for (int k = 0; k < launches; k++) {
            int at = k / Levels.COLOURS * Levels.INTS;
            int owners = levels.table[at + Levels.OWNERS];
            int first = levels.table[at + Levels.BASE] + k % Levels.COLOURS * owners;
            colours.get(k)
                    .arguments(
                            now.body,
                            buffers.kicked,
                            buffers.pair,
                            now.ids,
                            now.memory,
                            now.ownerStart,
                            state.status,
                            buffers.rule,
                            first,
                            owners)
                    .range(owners, group);
        }
        narrow.arguments(
                        now.body,
                        buffers.kicked,
                        buffers.pair,
                        now.ids,
                        now.memory,
                        now.ownerStart,
                        state.status,
                        buffers.rule,
                        now.levels,
                        wide,
                        levels.count)
                .range(1, oneGroup);
    }

    /** Levels up to the last that is worth launches of its own. */
    private static int wideLevels(Levels levels) {
        int wide = levels.count;
        while (wide > 0 && levels.table[Levels.INTS * (wide - 1) + Levels.OWNERS] <= Tuning.NARROW) {
            wide--;
        }
        return wide;
    }

    void run() {
        for (int k = 0; k < launches; k++) {
            colours.get(k).launch();
        }
        if (narrows) {
            narrow.launch();
        }
    }
}
