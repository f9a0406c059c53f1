package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;

/**
 * What the stages of small steps bind their kernels to.
 *
 * @param turn which of the two of each part of the heap the detection writes
 * @param known what every kernel begins with: {@link Heap#world}
 */
record SmallWorld(
        WorldConfig config,
        State state,
        Heap heap,
        int turn,
        Object[] known,
        Levels levels,
        Tiles tiles,
        OpenClDevice device) {

    /** Work-items of a group. */
    int group() {
        return device.group(config);
    }

    /** Work-items of a group that does a tile. */
    int tileGroup() {
        return device.tileGroup(config);
    }

    /** Work-items of a group that does a tile of the first tiling. */
    int firstTileGroup() {
        return device.firstTileGroup(config);
    }

    /** Work-items of a group that colours one. */
    int colourGroup() {
        return device.colourGroup(config);
    }

    /** Work-items of a launch of one group. */
    int oneGroup() {
        return device.oneGroup(config);
    }

    int circles() {
        return state.circles;
    }

    /** Whether circles are so few that the time of a launch counts more than what it does. */
    boolean few() {
        return config.smallWorld() > 0 && circles() <= Tuning.FEW_CIRCLES;
    }

    /**
     * Whether the world is so small that one work-group does it. On a CPU that is one of its cores: launches for all of them
     * would take longer.
     */
    boolean alone() {
        return tiles.tilings == 1 && circles() <= config.smallWorld() && Alone.localBytes(this) <= device.localMemory;
    }

    /** As {@link OpenClDevice#asOnGpu} says. */
    boolean asOnGpu() {
        return device.asOnGpu(config);
    }

    /** Work-items of a launch for contacts: about as many as there are; kernels go round where there are more. */
    long contacts() {
        return Math.max(1, 2L * state.circles);
    }
}
