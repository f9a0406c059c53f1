package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.Consumer;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Bad arguments: the message names argument and value, and nothing has changed. */
class BadInputTest {
    private static final float[] NOT_FINITE = {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY};

    private static void refused(String argument, Object value, Runnable call) {
        String message = assertThrows(IllegalArgumentException.class, call::run).getMessage();
        assertTrue(message.contains(argument + " = " + value), message);
    }

    /** A world that has run, and a check that a bad call leaves it as it is. */
    private static final class Probe implements AutoCloseable {
        private final Circles2D world;
        private final long hash;

        Probe(ComputeDevice device) {
            world = Circles2D.builder().device(device).bounds(0, 0, 2, 1).build();
            world.addCircle(0.5f, 0.5f, 0.1f, 1);
            world.addCircle(0.6f, 0.5f, 0.1f, 1);
            world.step();
            hash = world.stateHash();
        }

        void refuses(String argument, Object value, Consumer<Circles2D> call) {
            refused(argument, value, () -> call.accept(world));
            assertEquals(2, world.circleCount());
            assertEquals(hash, world.stateHash());
        }

        @Override
        public void close() {
            world.close();
        }
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void circles(Supplier<ComputeDevice> device) {
        try (Probe probe = new Probe(device.get())) {
            for (float bad : NOT_FINITE) {
                probe.refuses("x", bad, w -> w.addCircle(bad, 0.5f, 0.1f, 1));
                probe.refuses("y", bad, w -> w.addCircle(0.5f, bad, 0.1f, 1));
                probe.refuses("radius", bad, w -> w.addCircle(0.5f, 0.5f, bad, 1));
                probe.refuses("mass", bad, w -> w.addCircle(0.5f, 0.5f, 0.1f, bad));
                probe.refuses(
                        "vx",
                        bad,
                        w -> w.addCircle(new CircleDef().position(0.5f, 0.5f).velocity(bad, 0)));
                probe.refuses(
                        "vy",
                        bad,
                        w -> w.addCircle(new CircleDef().position(0.5f, 0.5f).velocity(0, bad)));
                probe.refuses("vx", bad, w -> w.setVelocity(0, bad, 0));
                probe.refuses("vy", bad, w -> w.setVelocity(0, 0, bad));
            }
            for (float bad : new float[] {0, -0.1f, 1e-10f, 2e9f}) {
                probe.refuses("radius", bad, w -> w.addCircle(0.5f, 0.5f, bad, 1));
                probe.refuses("mass", bad, w -> w.addCircle(0.5f, 0.5f, 0.1f, bad));
            }
            probe.refuses("x", 2.1f, w -> w.addCircle(2.1f, 0.5f, 0.1f, 1));
            probe.refuses("y", -0.1f, w -> w.addCircle(0.5f, -0.1f, 0.1f, 1));
            probe.refuses("radius", 0.51f, w -> w.addCircle(0.5f, 0.5f, 0.51f, 1));
            probe.refuses("radius", 1.5f, w -> w.addCircle(0.5f, 0.5f, 1.5f, 1));
            probe.refuses("vx", 2e9f, w -> w.setVelocity(0, 2e9f, 0));
            probe.refuses("def", null, w -> w.addCircle(null));
        }
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void handlesAndSteps(Supplier<ComputeDevice> device) {
        try (Probe probe = new Probe(device.get())) {
            for (long bad : new long[] {-1, 2, 1L << 32, Long.MIN_VALUE, Long.MAX_VALUE}) {
                probe.refuses("circle", bad, w -> w.setVelocity(bad, 0, 0));
            }
            probe.refuses("steps", -1, w -> w.step(-1));
            probe.refuses("steps", Integer.MIN_VALUE, w -> w.step(Integer.MIN_VALUE));
        }
    }

    @Test
    void builder() {
        Circles2D.Builder builder = Circles2D.builder();
        for (float bad : NOT_FINITE) {
            refused("timeStep", bad, () -> builder.timeStep(bad));
            refused("gravity ax", bad, () -> builder.gravity(bad, 0));
            refused("gravity ay", bad, () -> builder.gravity(0, bad));
            refused("restitution", bad, () -> builder.restitution(bad));
            refused("bounds minX", bad, () -> builder.bounds(bad, 0, 1, 1));
            refused("bounds minY", bad, () -> builder.bounds(0, bad, 1, 1));
            refused("bounds maxX", bad, () -> builder.bounds(0, 0, bad, 1));
            refused("bounds maxY", bad, () -> builder.bounds(0, 0, 1, bad));
        }
        refused("timeStep", 0f, () -> builder.timeStep(0));
        refused("timeStep", -0.1f, () -> builder.timeStep(-0.1f));
        refused("timeStep", 2000f, () -> builder.timeStep(2000));
        refused("gravity ay", -2e9f, () -> builder.gravity(0, -2e9f));
        refused("restitution", -0.1f, () -> builder.restitution(-0.1f));
        refused("restitution", 1.1f, () -> builder.restitution(1.1f));
        refused("bounds maxX", 2e9f, () -> builder.bounds(0, 0, 2e9f, 1));
        refused("bounds", "(1.0, 0.0) to (1.0, 1.0)", () -> builder.bounds(1, 0, 1, 1));
        refused("bounds", "(0.0, 2.0) to (1.0, 1.0)", () -> builder.bounds(0, 2, 1, 1));
        refused("capacity", -1, () -> builder.capacity(-1));
        refused("capacity", Integer.MAX_VALUE, () -> builder.capacity(Integer.MAX_VALUE));
    }

    @Test
    void nulls() {
        Circles2D.Builder builder = Circles2D.builder();
        refused("device", null, () -> builder.device(null));
        refused("strategy", null, () -> builder.indexStrategy(null));
        refused("store", null, () -> builder.collisionStore(null));
        refused("solver", null, () -> builder.solver(null));
        refused("nameOrIndex", null, () -> ComputeDevice.find(null));
    }

    /** A call that was refused leaves the builder as it was, in part too. */
    @Test
    void refusedBuilderCallsChangeNothing() {
        Circles2D.Builder builder = Circles2D.builder().device(ComputeDevice.host());
        refused("gravity ay", Float.NaN, () -> builder.gravity(5, Float.NaN));
        refused("bounds maxY", Float.NaN, () -> builder.bounds(-5, -5, 5, Float.NaN));
        refused("timeStep", 0f, () -> builder.timeStep(0));
        refused("restitution", 2f, () -> builder.restitution(2));
        try (Circles2D world = builder.build();
                Circles2D defaults =
                        Circles2D.builder().device(ComputeDevice.host()).build()) {
            for (Circles2D each : new Circles2D[] {world, defaults}) {
                each.addCircle(0.5f, 0.05f, 0.05f, 1);
                each.step(10);
            }
            assertEquals(defaults.stateHash(), world.stateHash());
        }
    }
}
