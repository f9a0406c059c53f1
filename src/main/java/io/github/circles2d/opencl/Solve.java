package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Levels;
import java.util.ArrayList;
import java.util.List;

/** Host code of {@code kernels/solve.cl}: one pass over the contacts, a level and a colour at a time. */
final class Solve {
    private final Session session;
    private final Program program;
    private final List<Kernel> colours = new ArrayList<>();
    private final Kernel list;
    private int launches;

    Solve(Session session, Program program) {
        this.session = session;
        this.program = program;
        list = new Kernel(session, program, "c2d_list");
    }

    void bind(State state, SmallBuffers buffers, Turn now, Levels levels, int group) {
        launches = Levels.COLOURS * levels.count;
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
        list.arguments(now.body, buffers.pair, now.ids, state.status, buffers.found)
                .range(Math.max(1, state.circles), group);
    }

    void run() {
        for (int k = 0; k < launches; k++) {
            colours.get(k).launch();
        }
    }

    /** Makes the contacts ready to be looked at, in {@code found}. */
    void list() {
        list.launch();
    }
}
