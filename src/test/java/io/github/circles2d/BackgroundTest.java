package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.demo.Scene;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Steps in the background: what comes of them, what snapshots show, how the thread ends. */
@Timeout(120)
class BackgroundTest {
    static Stream<Arguments> worlds() {
        return TestDevices.both()
                .flatMap(device -> Stream.of(Solver.values()).map(solver -> Arguments.of(device, solver)));
    }

    private static Circles2D world(ComputeDevice device, Solver solver, boolean background) {
        Circles2D.Builder builder =
                Circles2D.builder().device(device).solver(solver).capacity(1).background(background);
        return Scene.THESIS.build(builder, 200);
    }

    private static Circles2D world(ComputeDevice device) {
        return world(device, Solver.SMALL_STEPS, true);
    }

    private static boolean threadRuns() {
        return Thread.getAllStackTraces().keySet().stream()
                .anyMatch(thread -> thread.getName().equals("circles2d steps"));
    }

    private static float[] content(FloatBuffer buffer) {
        float[] all = new float[buffer.capacity()];
        buffer.duplicate().clear().get(all);
        return all;
    }

    /** Does the same to a world in the foreground and to one in the background. */
    private static void same(ComputeDevice device, Solver solver, Function<Circles2D, Object> use) {
        Object expected;
        try (Circles2D world = world(device, solver, false)) {
            expected = use.apply(world);
        }
        try (Circles2D world = world(device, solver, true)) {
            assertEquals(expected, use.apply(world));
        }
        assertFalse(threadRuns());
    }

    @ParameterizedTest
    @MethodSource("worlds")
    void manyStepsThatNobodyWaitsFor(Supplier<ComputeDevice> device, Solver solver) {
        same(device.get(), solver, world -> {
            for (int step = 0; step < 150; step++) {
                world.step();
            }
            return List.of(world.stateHash(), world.stats());
        });
    }

    @ParameterizedTest
    @MethodSource("worlds")
    void everythingElseBetweenSteps(Supplier<ComputeDevice> device, Solver solver) {
        same(device.get(), solver, BackgroundTest::everything);
    }

    private static List<Object> everything(Circles2D world) {
        List<Object> seen = new ArrayList<>();
        SplittableRandom random = new SplittableRandom(5);
        for (int frame = 0; frame < 60; frame++) {
            world.step(random.nextInt(4));
            switch (frame % 6) {
                case 0 -> world.addCircle((float) random.nextDouble(), 0.9f, 0.01f, 1);
                case 1 -> world.setVelocity(random.nextInt(world.circleCount()), 0.3f, 0.1f);
                case 2 -> seen.add(world.stats());
                case 3 -> seen.add(world.stateHash());
                case 4 -> {
                    Snapshot now = world.snapshot();
                    seen.add(now.y(now.count() - 1));
                    seen.add(now.transforms().get(1));
                    seen.add(now.velocities().get(1));
                }
                default -> assertTrue(world.deviceMemory() >= 0);
            }
        }
        // beyond the room that the world began with
        for (int i = 0; i < 300; i++) {
            world.addCircle((float) random.nextDouble(), (float) random.nextDouble(), 0.004f, 1);
            if (i % 50 == 0) {
                world.step();
            }
        }
        world.step(2);
        seen.add(world.stateHash());
        seen.add(world.circleCount());
        return seen;
    }

    /** More contacts than there is room for: the thread makes room. */
    @ParameterizedTest
    @EnumSource
    void roomRunsOut(Solver solver) {
        same(TestDevices.openCl(), solver, world -> {
            for (int i = 0; i < 250; i++) {
                world.addCircle(0.5f, 0.5f, 0.1f, 1 + i % 7);
            }
            world.step(solver == Solver.IMPULSE ? 3 : 1);
            return List.of(world.stateHash(), world.stats().contacts());
        });
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void emptyWorld(Supplier<ComputeDevice> device) {
        try (Circles2D world = Circles2D.builder()
                .device(device.get())
                .capacity(0)
                .background(true)
                .build()) {
            assertEquals(0, world.snapshot().transforms().limit());
            world.step();
            assertEquals(0, world.snapshot().count());
            assertEquals(0, world.snapshot().transforms().limit());
            assertEquals(0, world.snapshot().velocities().limit());
            assertEquals(new StepStats(1, 0, 0, 0, 0, 0, 0, 0, 0), world.stats());
            world.addCircle(0.5f, 0.5f, 0.1f, 1);
            world.step();
            assertTrue(world.snapshot().y(0) < 0.5f, "it falls");
        }
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void aBufferStaysAsItIsUntilTheStepAfterTheNextSnapshot(Supplier<ComputeDevice> device) {
        List<FloatBuffer> taken = new ArrayList<>();
        float[] last;
        try (Circles2D world = world(device.get())) {
            Snapshot now = world.snapshot();
            taken.add(now.transforms());
            for (int frame = 1; frame < 7; frame++) {
                FloatBuffer transforms = now.transforms();
                FloatBuffer velocities = now.velocities();
                float[] was = content(transforms);
                float[] velocitiesWere = content(velocities);
                assertEquals(4 * 200, transforms.limit());
                assertEquals(now.y(0), was[1]);
                world.step();
                // waits, and reads nothing back
                world.stats();
                assertArrayEquals(was, content(transforms), "while the step is made");
                assertArrayEquals(velocitiesWere, content(velocities));
                assertSame(transforms, now.transforms());
                assertEquals(was[1], now.y(0));
                assertSame(now, world.snapshot());
                assertArrayEquals(was, content(transforms), "behind the next snapshot");
                assertArrayEquals(velocitiesWere, content(velocities));
                taken.add(now.transforms());
                assertSame(now.transforms(), world.snapshot().transforms(), "no step, no change");
                assertEquals(now.y(0), now.transforms().get(1));
                assertTrue(was[1] != now.y(0), "the next snapshot shows something else");
                assertNotSame(transforms, now.transforms());
                assertSame(taken.get(frame % 2), now.transforms(), "they take turns");
            }
            last = content(now.transforms());
        }
        assertArrayEquals(last, content(taken.get(6)), "after the end");
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void aBufferThatAGrowingWorldHasReplacedStaysAsItIs(Supplier<ComputeDevice> device) {
        try (Circles2D world = world(device.get())) {
            world.step();
            FloatBuffer before = world.snapshot().transforms();
            float[] was = content(before);
            for (int i = 0; i < 400; i++) {
                world.addCircle(0.5f, 0.5f, 0.001f, 1);
            }
            for (int frame = 0; frame < 3; frame++) {
                world.step();
                assertEquals(4 * 600, world.snapshot().transforms().limit());
            }
            assertArrayEquals(was, content(before));
        }
    }

    /** More steps than a life has time for. */
    @ParameterizedTest
    @MethodSource("worlds")
    void closedWhileItRuns(Supplier<ComputeDevice> device, Solver solver) {
        Circles2D world = world(device.get(), solver, true);
        Snapshot now = world.snapshot();
        float y = now.y(7);
        world.step(Integer.MAX_VALUE);
        world.step(Integer.MAX_VALUE);
        assertTrue(threadRuns());
        world.close();
        assertFalse(threadRuns());
        assertEquals(y, now.y(7));
        assertEquals(y, now.transforms().get(4 * 7 + 1));
        assertThrows(IllegalStateException.class, world::step);
        assertThrows(IllegalStateException.class, world::snapshot);
        world.close();
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void waitingGoesOnThroughAnInterrupt(Supplier<ComputeDevice> device) {
        same(device.get(), Solver.SMALL_STEPS, world -> {
            world.step(20);
            Thread.currentThread().interrupt();
            long hash = world.stateHash();
            assertTrue(Thread.interrupted(), "the interrupt is still there");
            world.step(20);
            Thread.currentThread().interrupt();
            world.close();
            assertTrue(Thread.interrupted(), "the interrupt is still there");
            return hash;
        });
    }

    /** What a strategy of the user throws in a step, the device's failures apart, ends the world too. */
    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void whatAStrategyThrowsComesWithTheNextCall(Supplier<ComputeDevice> device) {
        ArithmeticException thrown = new ArithmeticException("the user's own");
        IndexStrategy users = new ThrowingStrategy(thrown);
        try (Circles2D world = Circles2D.builder()
                .device(device.get())
                .indexStrategy(users)
                .background(true)
                .build()) {
            world.addCircle(0.5f, 0.5f, 0.1f, 1);
            world.addCircle(0.6f, 0.5f, 0.1f, 1);
            world.step();
            assertSame(thrown, assertThrows(ArithmeticException.class, world::snapshot));
            assertSame(
                    thrown, assertThrows(Circles2DException.class, world::step).getCause());
        }
        assertFalse(threadRuns());
    }
}
