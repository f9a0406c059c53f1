package io.github.circles2d;

import io.github.circles2d.pipeline.DeviceState;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;

/** Computes {@link StepStats} from the host's copy of the circles and the contacts, read a part at a time. */
final class StatsReader {
    private static final int CONTACTS = 1 << 14;

    private final DeviceState stages;
    private final WorldConfig config;
    private final IntBuffer contact = ByteBuffer.allocateDirect(16 * CONTACTS)
            .order(ByteOrder.nativeOrder())
            .asIntBuffer();

    StatsReader(DeviceState stages, WorldConfig config) {
        this.stages = stages;
        this.config = config;
    }

    StepStats read(long steps, long contacts, CircleState state) {
        double deepest = 0;
        double sum = 0;
        long touching = 0;
        for (int from = 0; from < contacts; from += CONTACTS) {
            int part = (int) Math.min(CONTACTS, contacts - from);
            stages.contacts(from, part, contact);
            for (int k = 0; k < part; k++) {
                int i = contact.get(4 * k);
                int j = contact.get(4 * k + 1);
                double depth = config.solver() == Solver.SMALL_STEPS ? depth(state, i, j) : foundDepth(4 * k);
                if (depth > 0) {
                    double overlap = depth / Math.min(state.radius(i), state.radius(j));
                    deepest = Math.max(deepest, overlap);
                    sum += overlap;
                    touching++;
                }
            }
        }
        double energy = 0;
        double momentumX = 0;
        double momentumY = 0;
        double fastest = 0;
        int outside = 0;
        for (int slot = 0; slot < state.count(); slot++) {
            double mass = state.mass(slot);
            double vx = state.vx(slot);
            double vy = state.vy(slot);
            energy += mass * (vx * vx + vy * vy) / 2;
            momentumX += mass * vx;
            momentumY += mass * vy;
            fastest = Math.max(fastest, Math.hypot(vx, vy));
            outside += inside(state.x(slot), state.y(slot), state.radius(slot)) ? 0 : 1;
        }
        double mean = touching == 0 ? 0 : sum / touching;
        return new StepStats(steps, touching, deepest, mean, energy, momentumX, momentumY, fastest, outside);
    }

    /** The overlap of a contact as the step found it, world units. */
    private double foundDepth(int at) {
        return Math.hypot(Float.intBitsToFloat(contact.get(at + 2)), Float.intBitsToFloat(contact.get(at + 3)));
    }

    /** The overlap of two circles as they are now, world units. */
    private static double depth(CircleState state, int i, int j) {
        double dx = (double) state.x(j) - state.x(i);
        double dy = (double) state.y(j) - state.y(i);
        return (double) state.radius(i) + state.radius(j) - Math.sqrt(dx * dx + dy * dy);
    }

    /** In the arithmetic of the walls; NaN is outside. */
    private boolean inside(float x, float y, float radius) {
        if (config.solver() == Solver.SMALL_STEPS) {
            float half = 0.5f * radius;
            return x >= config.minX() + half
                    && x <= config.maxX() - half
                    && y >= config.minY() + half
                    && y <= config.maxY() - half;
        }
        return x >= config.minX() + radius
                && x <= config.maxX() - radius
                && y >= config.minY() + radius
                && y <= config.maxY() - radius;
    }
}
