package io.github.circles2d.pipeline;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;

/** A world's state on one device. Not thread-safe. */
public interface DeviceState extends AutoCloseable {
    /**
     * Reads the circles. Waits.
     *
     * @param circle (x, y, radius, mass) a circle, world units; direct, native order, written from 0
     * @param velocities (vx, vy) a circle, world units a second; direct, native order, written from 0
     */
    void download(FloatBuffer circle, FloatBuffer velocities);

    /** Waits for everything and says how far it went. */
    Status await();

    /** Makes room for the contacts of a step that stalled, and readies the device to detect it again. */
    void makeRoom(long contacts);

    /**
     * Reads contacts {@code from .. from + count - 1} of the last step, in the order they were found in. Waits. Of small
     * steps, those that are listed, touching or not, without the vectors.
     *
     * @param to an int4 a contact: the numbers i < j of its circles, and the bits of the vector that parts them, from i
     *     to j, world units; direct, native order, written from 0
     */
    void contacts(int from, int count, IntBuffer to);

    /** Releases everything the state owns. Idempotent. */
    @Override
    void close();
}
