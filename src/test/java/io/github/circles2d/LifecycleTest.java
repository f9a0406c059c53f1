package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

class LifecycleTest {
    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void everyCallAfterCloseThrows(Supplier<ComputeDevice> device) {
        Circles2D world = Circles2D.builder().device(device.get()).build();
        world.addCircle(0.5f, 0.5f, 0.1f, 1);
        world.step(3);
        world.close();
        world.close();
        List<Runnable> calls = List.of(
                () -> world.addCircle(0.5f, 0.5f, 0.1f, 1),
                () -> world.addCircle(new CircleDef()),
                () -> world.addCircle(null),
                () -> world.setVelocity(0, 0, 0),
                world::circleCount,
                world::step,
                () -> world.step(0),
                () -> world.step(2),
                world::snapshot,
                world::stateHash,
                world::stats,
                world::device);
        for (Runnable call : calls) {
            assertThrows(IllegalStateException.class, call::run);
        }
        world.close();
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void emptyWorld(Supplier<ComputeDevice> device) {
        try (Circles2D world =
                Circles2D.builder().device(device.get()).capacity(0).build()) {
            assertEquals(new StepStats(0, 0, 0, 0, 0, 0, 0, 0, 0), world.stats());
            long hash = world.stateHash();
            world.step(3);
            assertEquals(hash, world.stateHash());
            assertEquals(0, world.circleCount());
            assertEquals(0, world.snapshot().count());
            assertEquals(0, world.snapshot().transforms().limit());
            assertEquals(0, world.snapshot().velocities().limit());
            assertEquals(new StepStats(3, 0, 0, 0, 0, 0, 0, 0, 0), world.stats());
            assertEquals(0, world.addCircle(0.5f, 0.5f, 0.1f, 1));
            world.step();
            assertTrue(world.snapshot().y(0) < 0.5f, "it falls");
        }
    }

    /** Free fall: v = g t, d = g t^2 / 2. */
    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void oneCircleFalls(Supplier<ComputeDevice> device) {
        try (Circles2D world =
                Internals.thesis().device(device.get()).gravity(0.125f, -1).build()) {
            world.addCircle(0.5f, 0.9f, 0.05f, 1);
            world.step(30);
            Snapshot now = world.snapshot();
            assertEquals(0.5 + 0.125 / 8, now.x(0), 1e-6);
            assertEquals(0.9 - 1.0 / 8, now.y(0), 1e-6);
            assertEquals(0.0625, now.vx(0), 1e-6);
            assertEquals(-0.5, now.vy(0), 1e-6);
            assertEquals(30, world.stats().steps());
            assertEquals(Math.hypot(0.0625, 0.5), world.stats().maxSpeed(), 1e-6);
        }
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void noSteps(Supplier<ComputeDevice> device) {
        try (Circles2D world = Circles2D.builder().device(device.get()).build()) {
            world.addCircle(0, 0, 0.1f, 1);
            long hash = world.stateHash();
            world.step(0);
            assertEquals(hash, world.stateHash());
            assertEquals(0, world.stats().steps());
            assertEquals(0f, world.snapshot().x(0));
        }
    }

    /** A circle as wide as the world has one place to be. */
    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void circleThatJustFits(Supplier<ComputeDevice> device) {
        try (Circles2D world =
                Internals.thesis().device(device.get()).bounds(-1, -1, 3, 1).build()) {
            world.addCircle(3, 0.3f, 1, 1);
            world.setVelocity(0, 0, 1e6f);
            for (int step = 0; step < 5; step++) {
                world.step();
                assertEquals(0f, world.snapshot().y(0));
                assertEquals(0, world.stats().outside());
            }
        }
    }

    /** Circles come and velocities change between steps; OpenCL and plain Java see the same. */
    @ParameterizedTest
    @EnumSource(CollisionStore.class)
    void changesBetweenSteps(CollisionStore store) {
        try (Circles2D device = changing(TestDevices.openCl(), store);
                Circles2D host = changing(ComputeDevice.host(), store)) {
            SplittableRandom random = new SplittableRandom(11);
            for (int round = 0; round < 30; round++) {
                for (int k = random.nextInt(30); k > 0; k--) {
                    CircleDef def = new CircleDef()
                            .position((float) random.nextDouble(), (float) random.nextDouble())
                            .radius((float) random.nextDouble(0.002, 0.004) * (1 + round))
                            .mass((float) random.nextDouble(1, 5))
                            .velocity((float) random.nextDouble(-1, 1), 0);
                    assertEquals(host.addCircle(def), device.addCircle(def));
                }
                if (host.circleCount() > 0) {
                    int circle = random.nextInt(host.circleCount());
                    host.setVelocity(circle, 3, 1);
                    device.setVelocity(circle, 3, 1);
                    assertEquals(3f, device.snapshot().vx(circle));
                }
                int steps = random.nextInt(4);
                host.step(steps);
                device.step(steps);
                if (round % 3 == 0) {
                    assertEquals(host.stateHash(), device.stateHash(), "round " + round);
                }
            }
            // more than the room both began with, so that every buffer has grown
            assertTrue(host.circleCount() > 256, "circles " + host.circleCount());
            assertEquals(host.circleCount(), device.circleCount());
            assertEquals(host.stateHash(), device.stateHash());
        }
    }

    /** Straight after steps that nobody has waited for: their result stays, only the velocity changes. */
    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void velocitySetBehindQueuedSteps(Supplier<ComputeDevice> device) {
        try (Circles2D world = Internals.thesis().device(device.get()).build()) {
            world.addCircle(0.5f, 0.9f, 0.05f, 1);
            world.step(30);
            world.setVelocity(0, 0.25f, 0.5f);
            Snapshot now = world.snapshot();
            assertEquals(0.9 - 1.0 / 8, now.y(0), 1e-6);
            assertEquals(0.25f, now.vx(0));
            assertEquals(0.5f, now.vy(0));
        }
    }

    private static Circles2D changing(ComputeDevice device, CollisionStore store) {
        return Circles2D.builder()
                .device(device)
                .collisionStore(store)
                .indexStrategy(IndexStrategy.rowSearch())
                .capacity(1)
                .build();
    }

    @Test
    void aWorldKnowsItsDevice() {
        try (Circles2D world = Circles2D.builder().device(ComputeDevice.host()).build()) {
            assertSame(ComputeDevice.host(), world.device());
        }
    }

    /** The hash sees every number of a circle. */
    @Test
    void hashSeesEveryNumber() {
        float[] values = {0.5f, 0.25f, 0.1f, 2, 0.5f, -0.5f};
        long first = hash(values);
        assertEquals(first, hash(values));
        for (int k = 0; k < values.length; k++) {
            float[] changed = values.clone();
            changed[k] = Math.nextUp(changed[k]);
            assertTrue(first != hash(changed), "number " + k);
        }
    }

    private static long hash(float... v) {
        try (Circles2D world = Circles2D.builder().device(ComputeDevice.host()).build()) {
            world.addCircle(
                    new CircleDef().position(v[0], v[1]).radius(v[2]).mass(v[3]).velocity(v[4], v[5]));
            return world.stateHash();
        }
    }
}
