package io.github.circles2d.pipeline;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;

/**
 * The stages of a step on one device, and the state they work on. {@link Pipeline} calls them in order; calls may
 * return before the device is done, save those that say they wait. Not thread-safe.
 */
public interface Stages extends DeviceState {
    /**
     * Replaces the whole state. Waits.
     *
     * @param population the circles
     * @param velocities (vx, vy) a circle, world units a second; direct, native order, read from 0
     */
    void upload(Population population, FloatBuffer velocities);

    /** Integrates velocities and positions, walls included; empties the contacts. */
    void update();

    /** Finds the contacts. */
    void detect();

    /** Puts the contacts in the order of the cells and colours. */
    void colour();

    /** Moves circles apart and exchanges impulses. */
    void resolve();

    /**
     * Reads contacts {@code from .. from + count - 1} of the last step, in the order they were found in. Waits.
     *
     * @param to an int4 a contact: the numbers i < j of its circles, and the bits of the vector that parts them, from i
     *     to j, world units; direct, native order, written from 0
     */
    void contacts(int from, int count, IntBuffer to);
}
