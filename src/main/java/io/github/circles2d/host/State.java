package io.github.circles2d.host;

import java.nio.FloatBuffer;

/** The circles: the buffers {@code circle} and {@code velocities} of the kernels. */
final class State {
    int circles;
    /** (x, y, radius, mass) a circle. */
    float[] circle = {};
    /** (vx, vy) a circle. */
    float[] velocities = {};

    void upload(FloatBuffer newCircle, FloatBuffer newVelocities, int count) {
        if (4 * count > circle.length) {
            int room = newCircle.capacity() / 4;
            circle = new float[4 * room];
            velocities = new float[2 * room];
        }
        newCircle.get(0, circle, 0, 4 * count);
        newVelocities.get(0, velocities, 0, 2 * count);
        circles = count;
    }

    void download(FloatBuffer toCircle, FloatBuffer toVelocities) {
        toCircle.put(0, circle, 0, 4 * circles);
        toVelocities.put(0, velocities, 0, 2 * circles);
    }
}
