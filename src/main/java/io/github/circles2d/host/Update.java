package io.github.circles2d.host;

import io.github.circles2d.pipeline.WorldConfig;
import java.util.Arrays;

/** Twin of {@code kernels/update.cl}: moves every circle through one time step of constant acceleration. */
final class Update {
    private final WorldConfig config;
    private final State state;
    private final Contacts contacts;

    Update(WorldConfig config, State state, Contacts contacts) {
        this.config = config;
        this.state = state;
        this.contacts = contacts;
    }

    /** d = v t + g t^2 / 2 and v + g t (thesis, chapter 3), then the walls. */
    void run() {
        contacts.count = 0;
        Arrays.fill(contacts.cellStart, 0);
        for (int i = 0; i < state.circles; i++) {
            float radius = state.circle[4 * i + 2];
            axis(4 * i, 2 * i, config.velocityGainX(), config.fallX(), config.minX() + radius, config.maxX() - radius);
            axis(
                    4 * i + 1,
                    2 * i + 1,
                    config.velocityGainY(),
                    config.fallY(),
                    config.minY() + radius,
                    config.maxY() - radius);
        }
    }

    /**
     * One coordinate of one circle. At a wall the velocity turns over and keeps {@code restitution} of itself; so does
     * the way beyond the wall, which is covered after the bounce. A velocity that leads away from the wall stays.
     *
     * @param p index of the coordinate in {@code circle}
     * @param v index of its velocity in {@code velocities}
     * @param lo lowest place of the centre, world units
     * @param hi highest place of the centre, world units
     */
    private void axis(int p, int v, float gain, float fall, float lo, float hi) {
        float restitution = config.restitution();
        float position = state.circle[p] + (state.velocities[v] * config.timeStep() + fall);
        float velocity = state.velocities[v] + gain;
        if (position < lo) {
            position = lo + restitution * (lo - position);
            velocity = velocity < 0 ? -restitution * velocity : velocity;
        } else if (position > hi) {
            position = hi - restitution * (position - hi);
            velocity = velocity > 0 ? -restitution * velocity : velocity;
        }
        // faster than the world is wide: the far wall holds as well
        position = position < lo ? lo : position;
        state.circle[p] = position > hi ? hi : position;
        state.velocities[v] = velocity;
    }
}
