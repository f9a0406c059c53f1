package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;

/**
 * What the stages of small steps bind their kernels to.
 *
 * @param now the buffers that the detection writes
 * @param before those of the detection before
 * @param group work-items of a group
 * @param tileGroup work-items of a group that does a tile
 * @param firstTileGroup work-items of a group that does a tile of the first tiling
 * @param oneGroup work-items of a launch of one group
 */
record SmallWorld(
        WorldConfig config,
        State state,
        SmallBuffers buffers,
        Turn now,
        Turn before,
        Levels levels,
        Tiles tiles,
        int group,
        int tileGroup,
        int firstTileGroup,
        int oneGroup) {

    int circles() {
        return state.circles;
    }

    /** Whether circles are so few that the time of a launch counts more than what it does. */
    boolean few() {
        return config.smallWorld() > 0 && circles() <= Tuning.FEW_CIRCLES;
    }

    /**
     * Whether the world is so small that one work-group does it. On a CPU, that would be one of its cores; a size of groups that
     * is asked for has it done all the same.
     */
    boolean alone() {
        return circles() <= Math.min(config.smallWorld(), Tuning.ALONE_CIRCLES)
                && (state.onGpu() || config.workGroup() > 0);
    }

    /** Whether the first tiling begins with the circles' own share; where none is small, circles have launches of their own. */
    boolean fused() {
        return config.smallWorld() > 0;
    }

    /** Work-items of a launch for contacts: about as many as there are; kernels go round where there are more. */
    long contacts() {
        return Math.max(1, 2L * state.circles);
    }
}
