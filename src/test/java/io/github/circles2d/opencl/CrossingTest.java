package io.github.circles2d.opencl;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.CollisionStore;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import io.github.circles2d.TestDevices;
import io.github.circles2d.host.HostSmallStages;
import io.github.circles2d.pipeline.SmallPipeline;
import io.github.circles2d.pipeline.SmallStages;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Crossing contacts, {@code kernels/crossing.cl}, few and too many: the bits of plain Java either way. */
class CrossingTest {
    private static final float RADIUS = 0.004f;

    private static WorldConfig config(int group, float gravity) {
        return new WorldConfig(
                1f / 60,
                0,
                gravity,
                0.5f,
                0,
                0,
                1,
                1,
                IndexStrategy.grid(),
                CollisionStore.COMPACT,
                Solver.SMALL_STEPS,
                group,
                0,
                0,
                4);
    }

    private static FloatBuffer floats(int count) {
        return ByteBuffer.allocateDirect(4 * count)
                .order(ByteOrder.nativeOrder())
                .asFloatBuffer();
    }

    /** Circles on a disc of radius {@code spread}, which fly apart. */
    private static FloatBuffer heap(int circles, double spread) {
        SplittableRandom random = new SplittableRandom(3);
        FloatBuffer circle = floats(4 * circles);
        for (int i = 0; i < circles; i++) {
            double angle = random.nextDouble(2 * Math.PI);
            double distance = spread * Math.sqrt(random.nextDouble());
            circle.put(0.5f + (float) (distance * Math.cos(angle)));
            circle.put(0.5f + (float) (distance * Math.sin(angle)));
            circle.put(RADIUS).put(1);
        }
        return circle;
    }

    /** Circles that soon lie on the ground. */
    private static FloatBuffer layer(int circles) {
        SplittableRandom random = new SplittableRandom(4);
        FloatBuffer circle = floats(4 * circles);
        for (int i = 0; i < circles; i++) {
            circle.put((float) random.nextDouble()).put(0.2f * (float) random.nextDouble());
            circle.put(RADIUS * (0.7f + 0.3f * (float) random.nextDouble())).put(1);
        }
        return circle;
    }

    private static int[] bits(SmallStages stages, int circles) {
        FloatBuffer circle = floats(4 * circles);
        FloatBuffer velocities = floats(2 * circles);
        stages.download(circle, velocities);
        int[] bits = new int[6 * circles];
        for (int i = 0; i < circles; i++) {
            for (int k = 0; k < 4; k++) {
                bits[6 * i + k] = Float.floatToRawIntBits(circle.get(4 * i + k));
            }
            bits[6 * i + 4] = Float.floatToRawIntBits(velocities.get(2 * i));
            bits[6 * i + 5] = Float.floatToRawIntBits(velocities.get(2 * i + 1));
        }
        return bits;
    }

    /** Steps of both devices that are alike; of how many the device took the world to be crowded. */
    private static int compare(int group, float gravity, FloatBuffer circle, int steps) {
        WorldConfig config = config(group, gravity);
        int circles = circle.capacity() / 4;
        FloatBuffer velocities = floats(2 * circles);
        int crowded = 0;
        try (HostSmallStages host = new HostSmallStages(config);
                OpenClSmallStages device = new OpenClSmallStages((OpenClDevice) TestDevices.openClInside(), config)) {
            SmallPipeline one = new SmallPipeline(config, host);
            SmallPipeline other = new SmallPipeline(config, device);
            one.upload(circle, velocities, circles, RADIUS);
            other.upload(circle, velocities, circles, RADIUS);
            for (int step = 0; step < steps; step++) {
                one.step();
                one.await();
                other.step();
                other.await();
                assertArrayEquals(bits(host, circles), bits(device, circles), "step " + step);
                assertEquals(one.contacts(), other.contacts(), "step " + step);
                crowded += device.crowded() ? 1 : 0;
            }
            if (steps > 2 * Tuning.CROWDED_STEPS) {
                assertFalse(device.crowded(), "crowded for ever");
            }
        }
        return crowded;
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 7, 64})
    void fewAreDoneWithTheSecondTiling(int group) {
        assertEquals(0, compare(group, -1, layer(3000), 40));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 7, 64})
    void tooManyAreNotAndOnlyAsLongAsTheyAre(int group) {
        int steps = 2 * Tuning.CROWDED_STEPS + 20;
        // in one tile, and in all
        for (int circles : new int[] {1200, 2000}) {
            int crowded = compare(group, 0, heap(circles, 0.05), steps);
            assertTrue(crowded >= Tuning.CROWDED_STEPS && crowded < steps, "crowded in " + crowded + " steps");
        }
    }
}
