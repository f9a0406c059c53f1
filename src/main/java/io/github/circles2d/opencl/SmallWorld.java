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
        int oneGroup) {

    int circles() {
        return state.circles;
    }

    /** Whether circles are so few that the time of a launch counts more than what it does. */
    boolean few() {
        return config.smallWorld() > 0 && circles() <= Tuning.FEW_CIRCLES;
    }

    /** Groups that wait for each other: one on each unit, so that they can all run at once, or one alone. */
    int persistentGroups() {
        OpenClDevice device = state.device();
        return device.fence == DeviceFence.NONE ? 1 : Math.min(device.computeUnits, Tuning.PERSISTENT_MOST_GROUPS);
    }

    int persistentGroup() {
        return config.workGroup() > 0 ? config.workGroup() : Tuning.PERSISTENT_WORK_GROUP;
    }

    /** Work-items of a launch for contacts: about as many as there are; kernels go round where there are more. */
    long contacts() {
        return Math.max(1, 2L * state.circles);
    }
}
