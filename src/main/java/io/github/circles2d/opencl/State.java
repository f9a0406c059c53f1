package io.github.circles2d.opencl;

import java.nio.FloatBuffer;

/** The circles on the device: the buffers {@code circle} and {@code velocities} of the kernels. */
final class State {
    final DeviceBuffer circle;
    final DeviceBuffer velocities;
    int circles;

    State(Session session) {
        circle = new DeviceBuffer(session, "circle");
        velocities = new DeviceBuffer(session, "velocities");
    }

    void upload(FloatBuffer newCircle, FloatBuffer newVelocities, int count) {
        // room for as many as the host has room for: the buffers then grow as seldom as its own
        circle.ensure(16L * (newCircle.capacity() / 4));
        velocities.ensure(8L * (newCircle.capacity() / 4));
        circle.write(newCircle, 16L * count);
        velocities.write(newVelocities, 8L * count);
        circles = count;
    }

    void download(FloatBuffer toCircle, FloatBuffer toVelocities) {
        circle.read(0, toCircle, 16L * circles);
        velocities.read(0, toVelocities, 8L * circles);
    }
}
