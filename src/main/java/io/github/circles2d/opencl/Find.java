package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Tuning;
import java.util.ArrayList;
import java.util.List;

/** Host code of {@code kernels/find.cl}: lists the pairs of circles that may touch before the next detection. */
final class Find {
    private final Session session;
    private final Program program;
    private final PairTables tables;
    private final List<Kernel> count = new ArrayList<>();
    private final List<Kernel> fill = new ArrayList<>();
    private final Scan scan;

    /** @param tables the pairs, or null to look into the grid */
    Find(Session session, Program program, PairTables tables) {
        this.session = session;
        this.program = program;
        this.tables = tables;
        scan = new Scan(session, program);
    }

    void bind(SmallWorld world) {
        Object[] known = world.known();
        scan.bind(world, Heap.LIST_START, world.circles() + 1, true);
        bind(world, count, "c2d_find_count", known);
        bind(world, fill, "c2d_find_fill", known);
    }

    private void bind(SmallWorld world, List<Kernel> kernels, String name, Object[] known) {
        if (tables == null) {
            grow(kernels, name, 1);
            kernels.get(0).arguments(known).range(world.circles(), world.group());
            return;
        }
        List<PairTables.Slice> slices = tables.slices(world.circles());
        grow(kernels, name, slices.size());
        for (int s = 0; s < slices.size(); s++) {
            PairTables.Slice slice = slices.get(s);
            kernels.get(s)
                    .arguments(known, slice.table(), slice.first(), slice.pairs())
                    .range(slice.pairs(), world.group(), Tuning.PAIRS_PER_LAUNCH);
        }
    }

    private void grow(List<Kernel> kernels, String name, int wanted) {
        while (kernels.size() > wanted) {
            kernels.remove(kernels.size() - 1).close();
        }
        while (kernels.size() < wanted) {
            kernels.add(new Kernel(session, program, name));
        }
    }

    void run(float horizon, float slack) {
        run(count, horizon, slack);
        scan.run();
        run(fill, horizon, slack);
    }

    private static void run(List<Kernel> kernels, float horizon, float slack) {
        for (int s = 0; s < kernels.size(); s++) {
            kernels.get(s).more(horizon, slack);
            kernels.get(s).launch();
        }
    }
}
