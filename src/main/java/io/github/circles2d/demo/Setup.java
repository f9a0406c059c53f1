package io.github.circles2d.demo;

import io.github.circles2d.Circles2D;
import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;

/** What a world of the demo is made of. */
record Setup(
        Scene scene,
        int circles,
        Solver solver,
        int substeps,
        IndexStrategy strategy,
        CollisionStore store,
        ComputeDevice device) {

    /** A new world; the caller closes it. */
    Circles2D build() {
        Circles2D.Builder builder = Circles2D.builder()
                .device(device)
                .solver(solver)
                .substeps(substeps)
                .indexStrategy(strategy)
                .collisionStore(store);
        return scene.build(builder, circles);
    }
}
