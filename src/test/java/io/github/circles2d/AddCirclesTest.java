package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.pipeline.Tuning;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Circles added together are the same as one after the other. */
class AddCirclesTest {
    private static final int CIRCLES = 3 * Tuning.CHANGED_TOGETHER + 17;

    private static float[] circles(int count, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        float[] circles = new float[4 * count];
        for (int i = 0; i < count; i++) {
            circles[4 * i] = (float) random.nextDouble();
            circles[4 * i + 1] = (float) random.nextDouble();
            circles[4 * i + 2] = (float) random.nextDouble(0.002, 0.01);
            circles[4 * i + 3] = (float) random.nextDouble(1, 10);
        }
        return circles;
    }

    private static float[] velocities(int count) {
        SplittableRandom random = new SplittableRandom(3);
        float[] velocities = new float[2 * count];
        for (int i = 0; i < velocities.length; i++) {
            velocities[i] = (float) random.nextDouble(-1, 1);
        }
        return velocities;
    }

    private static void oneByOne(Circles2D world, float[] circles, float[] velocities) {
        CircleDef def = new CircleDef();
        for (int i = 0; i < circles.length / 4; i++) {
            def.position(circles[4 * i], circles[4 * i + 1])
                    .radius(circles[4 * i + 2])
                    .mass(circles[4 * i + 3]);
            world.addCircle(def.velocity(velocities[2 * i], velocities[2 * i + 1]));
        }
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void theSameAsOneAfterTheOther(Supplier<ComputeDevice> device) {
        float[] first = circles(CIRCLES, 1);
        float[] second = circles(CIRCLES / 2, 2);
        float[] going = velocities(CIRCLES);
        float[] atRest = new float[second.length / 2];
        for (boolean background : new boolean[] {false, true}) {
            Circles2D.Builder builder = Circles2D.builder().device(device.get()).background(background);
            try (Circles2D together = builder.build();
                    Circles2D apart = builder.build()) {
                assertEquals(0, together.addCircles(first, going));
                oneByOne(apart, first, going);
                assertEquals(apart.stateHash(), together.stateHash());
                together.step(3);
                apart.step(3);
                // to those that have moved
                assertEquals(CIRCLES, together.addCircles(second));
                oneByOne(apart, second, atRest);
                together.setVelocity(CIRCLES + 1, 0.5f, 0.5f);
                apart.setVelocity(CIRCLES + 1, 0.5f, 0.5f);
                assertEquals(apart.stateHash(), together.stateHash());
                together.step(3);
                apart.step(3);
                assertEquals(apart.stateHash(), together.stateHash());
                assertEquals(CIRCLES + CIRCLES / 2, together.circleCount());
            }
        }
    }

    @Test
    void areCopied() {
        float[] circles = circles(10, 1);
        float[] velocities = velocities(10);
        try (Circles2D world =
                Circles2D.builder().device(ComputeDevice.host()).capacity(20).build()) {
            world.addCircles(circles, velocities);
            float x = circles[4 * 9];
            long hash = world.stateHash();
            Arrays.fill(circles, 0);
            Arrays.fill(velocities, 0);
            assertEquals(hash, world.stateHash());
            Snapshot now = world.snapshot();
            assertEquals(x, now.x(9));
            assertEquals(0, now.transforms().get(4 * 9 + 3), "the angle");
        }
    }

    @Test
    void noneIsNothing() {
        try (Circles2D world =
                Circles2D.builder().device(ComputeDevice.host()).capacity(0).build()) {
            assertEquals(0, world.addCircles(new float[0]));
            assertEquals(0, world.addCircles(new float[0], new float[0]));
            world.step();
            assertEquals(0, world.circleCount());
            world.addCircle(0.5f, 0.5f, 0.1f, 1);
            assertEquals(1, world.addCircles(new float[0]));
            world.step();
            assertEquals(1, world.circleCount());
        }
    }

    private static void refused(Circles2D world, float[] circles, float[] velocities, String... named) {
        long hash = world.stateHash();
        String message = assertThrows(IllegalArgumentException.class, () -> world.addCircles(circles, velocities))
                .getMessage();
        for (String name : named) {
            assertTrue(message.contains(name), message);
        }
        assertEquals(2, world.circleCount());
        assertEquals(hash, world.stateHash());
    }

    @Test
    void allOrNone() {
        float[] good = circles(CIRCLES, 1);
        float[] going = velocities(CIRCLES);
        try (Circles2D world = Circles2D.builder().device(ComputeDevice.host()).build()) {
            world.addCircles(circles(2, 5));
            world.step();
            String[] names = {"x", "y", "radius", "mass"};
            for (int circle : new int[] {0, Tuning.CIRCLES_A_CALL, CIRCLES - 1}) {
                for (int k = 0; k < names.length; k++) {
                    float[] bad = good.clone();
                    bad[4 * circle + k] = -1;
                    refused(world, bad, going, "circle " + circle + ":", names[k] + " = -1.0");
                }
                float[] bad = good.clone();
                bad[4 * circle + 2] = 0.6f;
                refused(world, bad, going, "circle " + circle + ":", "radius = 0.6", "fit into the bounds");
                float[] fast = going.clone();
                fast[2 * circle + 1] = Float.NaN;
                refused(world, good, fast, "circle " + circle + ":", "vy = NaN");
            }
            refused(world, Arrays.copyOf(good, 9), going, "circles.length = 9", "4 numbers a circle");
            refused(world, Arrays.copyOf(good, 8), new float[3], "velocities.length = 3", "each of 2 circles");
            refused(world, good, null, "velocities = null");
            refused(world, null, going, "circles = null");
            assertThrows(IllegalArgumentException.class, () -> world.addCircles(null));
        }
    }
}
