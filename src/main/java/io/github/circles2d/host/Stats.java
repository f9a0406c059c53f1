package io.github.circles2d.host;

import io.github.circles2d.Solver;
import io.github.circles2d.pipeline.StepSums;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Twin of {@code kernels/stats.cl}: what a step looks like. */
final class Stats {
    private final StepSums sums = new StepSums();
    private final ByteBuffer part = ByteBuffer.allocate(StepSums.CIRCLES_BYTES).order(ByteOrder.nativeOrder());
    private final WorldConfig config;
    private final float[] circle;
    private final float[] velocities;
    /** Of the part at hand: the sum so far and what rounding has taken from it. */
    private float sum;

    private float lost;
    private long overlap;
    private int touching;
    private float largest;

    private Stats(WorldConfig config, float[] circle, float[] velocities) {
        this.config = config;
        this.circle = circle;
        this.velocities = velocities;
    }

    /** Of {@link Solver#IMPULSE}. */
    static StepSums ofFound(WorldConfig config, State state, Contacts contacts) {
        Stats stats = new Stats(config, state.circle, state.velocities);
        stats.circles(state.circles);
        for (int part = 0; part < StepSums.parts(contacts.count); part++) {
            for (int k = StepSums.PART * part; k < Math.min(contacts.count, StepSums.PART * (part + 1)); k++) {
                int at = Contacts.INTS * k;
                float x = Float.intBitsToFloat(contacts.found[at + 2]);
                float y = Float.intBitsToFloat(contacts.found[at + 3]);
                float a = state.circle[4 * contacts.found[at] + 2];
                float b = state.circle[4 * contacts.found[at + 1] + 2];
                stats.overlap((float) Math.sqrt(x * x + y * y), a < b ? a : b);
            }
            stats.endOfContacts();
        }
        return stats.sums;
    }

    /** Of {@link Solver#SMALL_STEPS}. */
    static StepSums ofLists(WorldConfig config, SmallState state, SmallContacts contacts) {
        Stats stats = new Stats(config, state.published.circle, state.published.velocities);
        stats.circles(state.circles);
        float[] body = state.body;
        for (int part = 0; part < StepSums.parts(state.circles); part++) {
            for (int i = StepSums.PART * part; i < Math.min(state.circles, StepSums.PART * (part + 1)); i++) {
                int a = SmallState.BODY * i;
                for (int k = contacts.listStart[i]; k < contacts.listStart[i + 1]; k++) {
                    int b = SmallState.BODY * contacts.other[k];
                    float dx = body[a] - body[b];
                    float dy = body[a + 1] - body[b + 1];
                    float ra = body[a + SmallState.RADIUS];
                    float rb = body[b + SmallState.RADIUS];
                    stats.overlap(ra + rb - (float) Math.sqrt(dx * dx + dy * dy), ra < rb ? ra : rb);
                }
            }
            stats.endOfContacts();
        }
        return stats.sums;
    }

    private void overlap(float depth, float smaller) {
        if (depth > 0) {
            float share = depth / smaller;
            touching++;
            largest = share > largest ? share : largest;
            overlap += (long) ((share < 4096 ? share : 4096) * 16777216f);
        }
    }

    private void endOfContacts() {
        part.putInt(0, (int) overlap).putInt(4, (int) (overlap >>> 32)).putInt(8, touching);
        sums.addContacts(part.putFloat(12, largest), 1);
        overlap = 0;
        touching = 0;
        largest = 0;
    }

    private void circles(int count) {
        for (int from = 0; from < count; from += StepSums.PART) {
            circlesOfPart(from, Math.min(count, from + StepSums.PART));
            sums.addCircles(part, 1);
        }
    }

    private void circlesOfPart(int from, int end) {
        float fastest = 0;
        int outside = 0;
        for (int i = from; i < end; i++) {
            float speed = (float) Math.sqrt(square(i));
            fastest = speed > fastest ? speed : fastest;
            outside += inside(4 * i) ? 0 : 1;
        }
        for (int which = 0; which < 3; which++) {
            sum = 0;
            lost = 0;
            for (int i = from; i < end; i++) {
                float mass = circle[4 * i + 3];
                plus(which == 0 ? 0.5f * mass * square(i) : mass * velocities[2 * i + which - 1]);
            }
            part.putFloat(8 * which, sum).putFloat(8 * which + 4, lost);
        }
        part.putFloat(24, fastest).putFloat(28, outside);
    }

    private float square(int i) {
        return velocities[2 * i] * velocities[2 * i] + velocities[2 * i + 1] * velocities[2 * i + 1];
    }

    /** {@code c2d_plus}. */
    private void plus(float x) {
        float next = sum + x;
        lost += Math.abs(sum) >= Math.abs(x) ? (sum - next) + x : (x - next) + sum;
        sum = next;
    }

    private boolean inside(int at) {
        float margin = config.inside() * circle[at + 2];
        return circle[at] >= config.minX() + margin
                && circle[at] <= config.maxX() - margin
                && circle[at + 1] >= config.minY() + margin
                && circle[at + 1] <= config.maxY() - margin;
    }
}
