package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Population;
import io.github.circles2d.pipeline.SmallSteps;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.FloatBuffer;
import java.util.SplittableRandom;

/** Circles at random: many that overlap, some on one spot, some over the walls, masses and speeds of every size. */
final class TwinState {
    private static final int SPOT = 30;

    final int count;
    final FloatBuffer transforms;
    final FloatBuffer masses;
    final FloatBuffer velocities;
    final float maxRadius;

    private TwinState(int count, float maxRadius, FloatBuffer masses) {
        this.count = count;
        this.maxRadius = maxRadius;
        this.masses = masses;
        transforms = SmallSteps.direct(4 * count);
        velocities = SmallSteps.direct(2 * count);
    }

    static TwinState random(WorldConfig config, int count, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        float width = config.maxX() - config.minX();
        float height = config.maxY() - config.minY();
        float largest = (float) (0.8 * height / Math.sqrt(count + 2) * random.nextDouble(0.3, 1));
        TwinState state = new TwinState(count, largest, SmallSteps.direct(count));
        float spotX = config.minX() + width * (float) random.nextDouble();
        float spotY = config.minY() + height * (float) random.nextDouble();
        for (int i = 0; i < count; i++) {
            boolean spot = i % 3 == 0 && i < 3 * SPOT;
            state.transforms.put(4 * i, spot ? spotX : config.minX() + width * (float) random.nextDouble());
            state.transforms.put(4 * i + 1, spot ? spotY : config.minY() + height * (float) random.nextDouble());
            state.transforms.put(4 * i + 2, i == 0 ? largest : largest * (float) random.nextDouble(0.2, 1));
            state.masses.put(i, (float) Math.pow(10, random.nextDouble(-9, 9)));
            // those on one spot at rest, most of them slow, some faster than the world is wide
            double speed = spot ? 0 : height * Math.pow(10, random.nextDouble(-4, i % 5 == 0 ? 3 : 0));
            double angle = random.nextDouble(0, 2 * Math.PI);
            state.velocities.put(2 * i, (float) (speed * Math.cos(angle)));
            state.velocities.put(2 * i + 1, (float) (speed * Math.sin(angle)));
        }
        return state;
    }

    /** The circles. */
    Population population() {
        return Population.of(transforms, masses, count);
    }

    /** Room for what is read back. */
    TwinState empty() {
        return new TwinState(count, maxRadius, masses);
    }

    /** Centre, radius, angle and velocity of each circle, as bits. */
    int[] bits() {
        return SmallSteps.bits(transforms, velocities, count);
    }
}
