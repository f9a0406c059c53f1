package io.github.circles2d.pipeline;

import java.nio.FloatBuffer;

/**
 * The stages of a step on one device, and the state they work on. {@link Pipeline} calls them in order; calls may
 * return before the device is done, save those that say they wait. Not thread-safe.
 */
public interface Stages extends DeviceState {
    /**
     * Replaces the whole state. Waits.
     *
     * @param circle (x, y, radius, mass) a circle, world units; direct, native order, read from 0
     * @param velocities (vx, vy) a circle, world units a second; direct, native order, read from 0
     * @param maxRadius largest radius among them, world units
     */
    void upload(FloatBuffer circle, FloatBuffer velocities, int circles, float maxRadius);

    /** Integrates velocities and positions, walls included; empties the contacts. */
    void update();

    /** Finds the contacts. */
    void detect();

    /** Puts the contacts in the order of the cells and colours. */
    void colour();

    /** Moves circles apart and exchanges impulses. */
    void resolve();
}
