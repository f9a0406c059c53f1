package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Tuning;
import java.util.ArrayList;
import java.util.List;

/** Host code of {@code kernels/find.cl}: lists the pairs of circles that may touch before the next detection. */
final class Find {
    private final Session session;
    private final Program program;
    private final PairTables tables;
    private final List<Kernel> kernels = new ArrayList<>();

    /** @param tables the pairs, or null to look into the grid */
    Find(Session session, Program program, PairTables tables) {
        this.session = session;
        this.program = program;
        this.tables = tables;
    }

    void bind(State state, SmallBuffers buffers, Turn now, Levels levels, int group) {
        Object[] found = {
            now.body,
            now.id,
            now.cell,
            now.levels,
            buffers.rule,
            now.ownerStart,
            buffers.found,
            buffers.foundOwner,
            state.status,
            buffers.capacity()
        };
        if (tables == null) {
            grow(1);
            kernels.get(0)
                    .arguments(found, buffers.bucketStart, state.circles, levels.count)
                    .range(state.circles, group);
            return;
        }
        List<PairTables.Slice> slices = tables.slices(state.circles);
        grow(slices.size());
        for (int s = 0; s < slices.size(); s++) {
            PairTables.Slice slice = slices.get(s);
            kernels.get(s)
                    .arguments(found, slice.table(), state.circles, slice.first(), slice.pairs())
                    .range(slice.pairs(), group, Tuning.PAIRS_PER_LAUNCH);
        }
    }

    private void grow(int wanted) {
        while (kernels.size() > wanted) {
            kernels.remove(kernels.size() - 1).close();
        }
        while (kernels.size() < wanted) {
            kernels.add(new Kernel(session, program, tables == null ? "c2d_find" : "c2d_find_pairs"));
        }
    }

    void run(float horizon, float fall) {
        for (int s = 0; s < kernels.size(); s++) {
            kernels.get(s).more(horizon, fall);
            kernels.get(s).launch();
        }
    }
}
