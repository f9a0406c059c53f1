package io.github.circles2d.host;

import io.github.circles2d.pipeline.Changes;
import io.github.circles2d.pipeline.CircleBuffers;
import io.github.circles2d.pipeline.Population;
import java.nio.FloatBuffer;

/** The circles: the buffers {@code circle} and {@code velocities} of the kernels. */
final class State {
    int circles;
    /** (x, y, radius, mass) a circle. */
    float[] circle = {};
    /** (vx, vy) a circle. */
    float[] velocities = {};

    void upload(Population population, FloatBuffer newVelocities) {
        int count = population.circles();
        if (4 * count > circle.length) {
            int room = population.transforms().capacity() / 4;
            circle = new float[4 * room];
            velocities = new float[2 * room];
        }
        population.transforms().get(0, circle, 0, 4 * count);
        for (int i = 0; i < count; i++) {
            circle[4 * i + 3] = population.masses().get(i);
        }
        newVelocities.get(0, velocities, 0, 2 * count);
        circles = count;
    }

    void velocities(FloatBuffer newVelocities, Changes changed) {
        changed.rewind(circles, 0);
        while (changed.next()) {
            int first = 2 * changed.from();
            newVelocities.get(first, velocities, first, 2 * changed.end() - first);
        }
    }

    void download(FloatBuffer transforms, FloatBuffer toVelocities) {
        transforms.put(0, circle, 0, 4 * circles);
        CircleBuffers.setAngles(transforms, 0, circles);
        toVelocities.put(0, velocities, 0, 2 * circles);
    }
}
