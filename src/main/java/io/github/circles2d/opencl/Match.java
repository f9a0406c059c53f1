package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Levels;

/**
 * Host code of {@code kernels/match.cl}: sorts the contacts by owner and numbers, and gives each what the detection before
 * remembers of it.
 */
final class Match {
    private final Scan scan;
    private final Kernel scatter;
    private final Kernel match;

    Match(Session session, Program program) {
        scan = new Scan(session, program);
        scatter = new Kernel(session, program, "c2d_match_scatter");
        match = new Kernel(session, program, "c2d_match");
    }

    void bind(State state, SmallBuffers buffers, Turn now, Turn before, Levels levels, int group, int oneGroup) {
        // contacts are about twice as many as circles; the kernels go round where they are more
        long items = Math.max(1, 2L * state.circles);
        scan.bind(now.ownerStart, levels.cells + 1, state, buffers, group, oneGroup);
        scatter.arguments(
                        buffers.found,
                        buffers.foundOwner,
                        now.ownerStart,
                        state.status,
                        buffers.byOwner,
                        buffers.ownerOf)
                .range(items, group);
        match.arguments(
                        buffers.byOwner,
                        buffers.ownerOf,
                        now.ownerStart,
                        state.status,
                        before.cell,
                        before.levels,
                        before.ownerStart,
                        before.ids,
                        before.memory,
                        buffers.pair,
                        now.ids,
                        now.memory)
                .range(items, group);
    }

    void run() {
        scan.run();
        scatter.launch();
        match.launch();
    }
}
