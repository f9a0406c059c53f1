package io.github.circles2d.opencl;

import io.github.circles2d.CollisionStore;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import io.github.circles2d.pipeline.WorldConfig;
import java.util.List;

/** A way to run the stages, for {@link KernelTwinsTest}. */
record TwinCase(
        CollisionStore store,
        IndexStrategy strategy,
        int smallWorld,
        long pairsPerSlice,
        int workGroup,
        float restitution,
        float size) {
    static List<TwinCase> all() {
        return List.of(
                new TwinCase(CollisionStore.COMPACT, IndexStrategy.folded(), 0, 0, 0, 0.5f, 1),
                new TwinCase(CollisionStore.COMPACT, IndexStrategy.pairTable(), 0, 997, 7, 1, 1000),
                new TwinCase(CollisionStore.TRIANGLE, IndexStrategy.rowSearch(), 0, 0, 64, 0, 0.01f),
                new TwinCase(CollisionStore.TRIANGLE, IndexStrategy.formula(), 0, 2_011, 1, 0.9f, 1),
                new TwinCase(CollisionStore.COMPACT, IndexStrategy.formula(), 4096, 0, 0, 1, 0.01f),
                new TwinCase(CollisionStore.COMPACT, IndexStrategy.rowSearch(), 4096, 2_011, 64, 0.5f, 1),
                new TwinCase(CollisionStore.TRIANGLE, IndexStrategy.folded(), 4096, 0, 7, 0, 1000),
                new TwinCase(CollisionStore.TRIANGLE, IndexStrategy.pairTable(), 4096, 997, 256, 0.7f, 1));
    }

    /** A box that is not square and not at the origin. */
    WorldConfig config() {
        return new WorldConfig(
                1f / 60,
                0.3f * size,
                -1 * size,
                restitution,
                -0.4f * size,
                0.1f * size,
                0.7f * size,
                0.9f * size,
                strategy,
                store,
                Solver.IMPULSE,
                workGroup,
                pairsPerSlice,
                smallWorld,
                0,
                0);
    }
}
