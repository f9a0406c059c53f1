package io.github.circles2d.host;

import io.github.circles2d.pipeline.CellGrid;
import io.github.circles2d.pipeline.WorldConfig;

/** Twin of {@code kernels/resolve.cl}: {@link io.github.circles2d.Solver#IMPULSE}, in the order that colour made. */
final class Resolve {
    private final WorldConfig config;
    private final State state;
    private final Contacts contacts;

    Resolve(WorldConfig config, State state, Contacts contacts) {
        this.config = config;
        this.state = state;
        this.contacts = contacts;
    }

    void run(CellGrid cells) {
        for (int colour = 0; colour < CellGrid.COLOURS; colour++) {
            int owners = cells.owners(colour);
            for (int item = 0; item < owners; item++) {
                int cell = cells.owner(item, colour);
                for (int k = contacts.cellStart[cell]; k < contacts.cellStart[cell + 1]; k++) {
                    contact(Contacts.INTS * k);
                }
            }
        }
    }

    /**
     * Parts two circles by the translation vector, each by its share of the inverse masses, and, if they approach, gives
     * them the impulse J = -(1 + e) v_ab . n / (1/m_a + 1/m_b) along the normal n (thesis, chapter 3).
     */
    private void contact(int at) {
        float[] circle = state.circle;
        float[] velocities = state.velocities;
        int a = contacts.contact[at];
        int b = contacts.contact[at + 1];
        float tx = Float.intBitsToFloat(contacts.contact[at + 2]);
        float ty = Float.intBitsToFloat(contacts.contact[at + 3]);
        float inverseA = 1 / circle[4 * a + 3];
        float inverseB = 1 / circle[4 * b + 3];
        float inverseSum = inverseA + inverseB;
        float shareA = inverseA / inverseSum;
        float shareB = inverseB / inverseSum;
        move(a, -(tx * shareA), -(ty * shareA));
        move(b, tx * shareB, ty * shareB);

        float depth = (float) Math.sqrt(tx * tx + ty * ty);
        float nx = tx / depth;
        float ny = ty / depth;
        float approach =
                (velocities[2 * a] - velocities[2 * b]) * nx + (velocities[2 * a + 1] - velocities[2 * b + 1]) * ny;
        if (approach > 0) {
            float impulse = -(1 + config.restitution()) * approach / inverseSum;
            float gainA = impulse * inverseA;
            float gainB = impulse * inverseB;
            velocities[2 * a] += gainA * nx;
            velocities[2 * a + 1] += gainA * ny;
            velocities[2 * b] -= gainB * nx;
            velocities[2 * b + 1] -= gainB * ny;
        }
    }

    /** A circle pushed into a wall stops there. */
    private void move(int i, float dx, float dy) {
        float[] circle = state.circle;
        float radius = circle[4 * i + 2];
        circle[4 * i] = within(circle[4 * i] + dx, config.minX() + radius, config.maxX() - radius);
        circle[4 * i + 1] = within(circle[4 * i + 1] + dy, config.minY() + radius, config.maxY() - radius);
    }

    private static float within(float position, float lo, float hi) {
        float low = position < lo ? lo : position;
        return low > hi ? hi : low;
    }
}
