package io.github.circles2d.host;

import io.github.circles2d.ComputeDevice;
import io.github.circles2d.pipeline.Device;
import io.github.circles2d.pipeline.SmallStages;
import io.github.circles2d.pipeline.Stages;
import io.github.circles2d.pipeline.WorldConfig;

/** Plain Java as a device. */
public final class HostDevice implements Device {
    @Override
    public String name() {
        return "host";
    }

    @Override
    public String platform() {
        return "plain Java " + Runtime.version().feature();
    }

    @Override
    public ComputeDevice.Type type() {
        return ComputeDevice.Type.HOST;
    }

    @Override
    public boolean deterministic() {
        return true;
    }

    @Override
    public Stages open(WorldConfig config) {
        return new HostStages(config);
    }

    @Override
    public SmallStages openSmall(WorldConfig config) {
        return new HostSmallStages(config);
    }
}
