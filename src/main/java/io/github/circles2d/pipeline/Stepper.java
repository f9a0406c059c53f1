package io.github.circles2d.pipeline;

import java.nio.FloatBuffer;

/** Makes the steps of one world: calls the stages of a solver in order, the same for every device. Not thread-safe. */
public interface Stepper {
    /**
     * Replaces the circles. Those that were there keep their numbers, radii, masses and what the solver remembers of them, and are where
     * the last step has left them; others may have come after them, and any velocity be another. Waits.
     *
     * @param population the circles
     * @param velocities (vx, vy) a circle, world units a second; direct, native order, read from 0
     * @param changed those that have come since the last step, and those whose velocity is another than after it
     */
    void upload(Population population, FloatBuffer velocities, Changes changed);

    /** The same where no circle has come: velocities alone. Waits. */
    void velocities(FloatBuffer velocities, Changes changed);

    /** Queues one step. */
    void step();

    /** Waits until every queued step is done, growing the room for contacts where one needs it. */
    void await();

    /** Contacts of the last step that {@link #await()} saw. */
    long contacts();
}
