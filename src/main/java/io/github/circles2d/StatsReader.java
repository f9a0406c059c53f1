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
                float smaller = Math.min(state.radius(contact.get(4 * k)), state.radius(contact.get(4 * k + 1)));
                float x = Float.intBitsToFloat(contact.get(4 * k + 2));
                float y = Float.intBitsToFloat(contact.get(4 * k + 3));
                double overlap = Math.hypot(x, y) / smaller;
                touching += x != 0 || y != 0 ? 1 : 0;
                deepest = Math.max(deepest, overlap);
                sum += overlap;
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
