package io.github.circles2d.pipeline;

import io.github.circles2d.ComputeDevice;

/** What a {@link ComputeDevice} stands for: something that runs the stages. */
public interface Device {
    /** The name its driver gives. */
    String name();

    /** The platform and version its driver gives. */
    String platform();

    ComputeDevice.Type type();

    /** Whether its arithmetic gives the bits of Java. The first call may run a check on the device. */
    boolean deterministic();

    /** A new, empty world of {@link io.github.circles2d.Solver#IMPULSE}. */
    Stages open(WorldConfig config);

    /** A new, empty world of {@link io.github.circles2d.Solver#SMALL_STEPS}. */
    SmallStages openSmall(WorldConfig config);
}
