package io.github.circles2d.host;

import io.github.circles2d.pipeline.WorldConfig;

/**
 * Twin of {@code kernels/contact.cl}: the rule of one contact, {@link io.github.circles2d.Solver#IMPULSE}. The device makes
 * contacts ready all at once and resolves them in order; here each is made ready where it is resolved.
 */
final class Contact {
    private final WorldConfig config;
    private final State state;

    Contact(WorldConfig config, State state) {
        this.config = config;
        this.state = state;
    }

    /**
     * Moves two circles apart by the translation vector t, each by its share of the inverse masses,
     * (1/m_a) / (1/m_a + 1/m_b), and, if they approach, gives them the impulse J = -(1 + e) v_ab . n / (1/m_a + 1/m_b)
     * along the normal n = t / |t|: what a gains is J / m_a, that is (1 + e) times its share times v_ab . n (thesis,
     * chapter 3).
     *
     * @param contact contacts as {@link Contacts#contact} holds them
     * @param at where in it the contact begins
     */
    void resolve(int[] contact, int at) {
        float[] circle = state.circle;
        float[] velocities = state.velocities;
        int a = contact[at];
        int b = contact[at + 1];
        float tx = Float.intBitsToFloat(contact[at + 2]);
        float ty = Float.intBitsToFloat(contact[at + 3]);
        float depth = (float) Math.sqrt(tx * tx + ty * ty);
        float nx = tx / depth;
        float ny = ty / depth;
        float inverseA = 1 / circle[4 * a + 3];
        float inverseB = 1 / circle[4 * b + 3];
        float inverseSum = inverseA + inverseB;
        float shareA = inverseA / inverseSum;
        float shareB = inverseB / inverseSum;

        move(a, -(depth * shareA), nx, ny);
        move(b, depth * shareB, nx, ny);

        float approach =
                (velocities[2 * a] - velocities[2 * b]) * nx + (velocities[2 * a + 1] - velocities[2 * b + 1]) * ny;
        if (approach > 0) {
            float bounce = 1 + config.restitution();
            float lossA = bounce * shareA * approach;
            float lossB = bounce * shareB * approach;
            velocities[2 * a] -= lossA * nx;
            velocities[2 * a + 1] -= lossA * ny;
            velocities[2 * b] += lossB * nx;
            velocities[2 * b + 1] += lossB * ny;
        }
    }

    /** A circle pushed into a wall stops there. */
    private void move(int i, float distance, float nx, float ny) {
        float[] circle = state.circle;
        float radius = circle[4 * i + 2];
        circle[4 * i] = within(circle[4 * i] + distance * nx, config.minX() + radius, config.maxX() - radius);
        circle[4 * i + 1] = within(circle[4 * i + 1] + distance * ny, config.minY() + radius, config.maxY() - radius);
    }

    private static float within(float position, float lo, float hi) {
        float low = position < lo ? lo : position;
        return low > hi ? hi : low;
    }
}
