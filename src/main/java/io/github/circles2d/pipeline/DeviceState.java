package io.github.circles2d.pipeline;

import java.nio.FloatBuffer;

/** A world's state on one device. Not thread-safe. */
public interface DeviceState extends AutoCloseable {
    /**
     * Replaces velocities of circles that are there. Waits.
     *
     * @param velocities (vx, vy) a circle, world units a second; direct, native order, read from 0
     * @param changed whose are others
     */
    void velocities(FloatBuffer velocities, Changes changed);

    /**
     * Reads the circles. Waits.
     *
     * @param transforms (x, y, radius, 0) a circle, world units; direct, native order, written from 0
     * @param velocities (vx, vy) a circle, world units a second; direct, native order, written from 0
     */
    void download(FloatBuffer transforms, FloatBuffer velocities);

    /**
     * Waits for everything and says how far it went.
     *
     * @param reading whether {@link #download} is to follow: a small world then comes back with what is said of it
     */
    Status await(boolean reading);

    /** Makes room for the contacts of a step that stalled, and readies the device to detect it again. */
    void makeRoom(long contacts);

    /** What the last step looks like, computed on the device; after {@link #await}. Waits. */
    StepSums sums();

    /** Memory of the device that the state takes, bytes; 0 in plain Java, where it is on the heap. */
    long bytes();

    /** Releases everything the state owns. Idempotent. */
    @Override
    void close();
}
