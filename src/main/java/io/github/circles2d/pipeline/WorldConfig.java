package io.github.circles2d.pipeline;

import io.github.circles2d.CollisionStore;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;

/**
 * What a world is built from; fixed for its life. Units as in {@code Circles2D.Builder}.
 *
 * @param workGroup work-items of a group, 0 for what suits the device
 * @param pairsPerSlice most pairs that share one buffer of the triangle or of a table, 0 for what the device allows
 * @param smallWorld largest world, in circles, that is coloured and resolved by one work-group; of small steps, it
 *     is {@code oneTile} at most, and 0 says besides that no world is of few circles, {@link Tuning#FEW_CIRCLES}
 * @param oneTile largest world, in circles, that is one of the {@link Tiles}: {@link Tuning#ALONE_CIRCLES} for all but tests, since
 *     the order of contacts, and so every bit, follows from it
 * @param substeps substeps of a step, 0 to choose
 */
public record WorldConfig(
        float timeStep,
        float gravityX,
        float gravityY,
        float restitution,
        float minX,
        float minY,
        float maxX,
        float maxY,
        IndexStrategy strategy,
        CollisionStore store,
        Solver solver,
        int workGroup,
        long pairsPerSlice,
        int smallWorld,
        int oneTile,
        int substeps) {

    /** Whether translation vectors go to the triangle: only detect by pairs has one. */
    public boolean triangle() {
        return store == CollisionStore.TRIANGLE && strategy.pairwise() && solver == Solver.IMPULSE;
    }

    /** Share of its radius that the centre of a circle keeps from the walls; less is outside. */
    public float inside() {
        return solver == Solver.IMPULSE ? 1 : Tuning.INSIDE;
    }

    /** What gravity adds to a velocity in one step, world units a second. */
    public float velocityGainX() {
        return gravityX * timeStep;
    }

    /** See {@link #velocityGainX()}. */
    public float velocityGainY() {
        return gravityY * timeStep;
    }

    /** How far gravity alone moves a circle at rest in one step, world units: g t^2 / 2 (thesis, chapter 3). */
    public float fallX() {
        return 0.5f * gravityX * timeStep * timeStep;
    }

    /** See {@link #fallX()}. */
    public float fallY() {
        return 0.5f * gravityY * timeStep * timeStep;
    }
}
