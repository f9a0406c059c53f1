package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.WorldConfig;

/**
 * What the stages of small steps bind their kernels to.
 *
 * @param now the buffers that the detection writes
 * @param before those of the detection before
 * @param group work-items of a group
 * @param oneGroup work-items of a launch of one group
 */
record SmallWorld(
        WorldConfig config,
        State state,
        SmallBuffers buffers,
        Turn now,
        Turn before,
        Levels levels,
        int group,
        int oneGroup) {

    int circles() {
        return state.circles;
    }
}
