package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.demo.Scene;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** What many circles keep: momentum, energy, their place within the walls. */
class ConservationTest {
    /** Rounding of one step, of the energy: half a unit in the last place of a float, some times over. */
    private static final double ROUNDING = 3e-7;

    private static double sumOfMomenta(Snapshot now) {
        double sum = 0;
        for (int slot = 0; slot < now.count(); slot++) {
            sum += now.mass(slot) * Math.hypot(now.vx(slot), now.vy(slot));
        }
        return sum;
    }

    /** Circles that fly about in the middle of a box whose walls they do not reach. */
    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void momentumOfAFreeGas(Supplier<ComputeDevice> device) {
        Circles2D.Builder builder = Internals.thesis()
                .device(device.get())
                .timeStep(1f / 240)
                .gravity(0, 0)
                .restitution(1)
                .bounds(-20, -20, 20, 20);
        try (Circles2D world = builder.build()) {
            SplittableRandom random = new SplittableRandom(3);
            CircleDef def = new CircleDef().radius(0.04f);
            for (int i = 0; i < 100; i++) {
                def.position(0.1f * (i % 10), 0.1f * (i / 10)).mass((float) random.nextDouble(0.5, 10));
                def.velocity((float) random.nextDouble(-0.5, 0.5), (float) random.nextDouble(-0.5, 0.5));
                world.addCircle(def);
            }
            StepStats before = world.stats();
            double total = sumOfMomenta(world.snapshot());
            double firstVx = world.snapshot().vx(0);
            long contacts = 0;
            for (int step = 0; step < 1000; step++) {
                world.step();
                contacts += world.stats().contacts();
            }
            StepStats after = world.stats();
            assertTrue(contacts > 100, "contacts " + contacts);
            Snapshot end = world.snapshot();
            for (int slot = 0; slot < end.count(); slot++) {
                assertTrue(Math.max(Math.abs(end.x(slot)), Math.abs(end.y(slot))) < 19, "a wall is near");
            }
            assertNotEquals(firstVx, world.snapshot().vx(0));
            double drift = Math.hypot(after.momentumX() - before.momentumX(), after.momentumY() - before.momentumY());
            assertTrue(drift < 1e-5 * total, "drift " + drift + " of " + total);
        }
    }

    static List<Arguments> restitutions() {
        List<Arguments> all = new ArrayList<>();
        TestDevices.both().forEach(device -> {
            for (float restitution : new float[] {0, 0.5f, 1}) {
                all.add(Arguments.of(device, restitution));
            }
        });
        return all;
    }

    @ParameterizedTest
    @MethodSource("restitutions")
    void energyNeverGrows(Supplier<ComputeDevice> device, float restitution) {
        Scene scene = new Scene("gas", 0, 0, restitution, Scene.GAS.circles());
        try (Circles2D world = scene.build(Internals.thesis().device(device.get()), 150)) {
            double start = world.stats().kineticEnergy();
            double energy = start;
            long contacts = 0;
            for (int step = 0; step < 300; step++) {
                world.step();
                StepStats stats = world.stats();
                contacts += stats.contacts();
                assertTrue(
                        stats.kineticEnergy() <= energy * (1 + ROUNDING),
                        "step " + step + ": " + energy + " to " + stats.kineticEnergy());
                energy = stats.kineticEnergy();
            }
            assertTrue(contacts > 100, "contacts " + contacts);
            if (restitution == 1) {
                assertEquals(start, energy, 1e-4 * start);
            } else {
                assertTrue(energy < 0.9 * start, "left " + energy + " of " + start);
            }
        }
    }

    private static void checkInside(Circles2D world) {
        assertEquals(0, world.stats().outside());
        Snapshot now = world.snapshot();
        for (int slot = 0; slot < now.count(); slot++) {
            float radius = now.radius(slot);
            assertTrue(now.x(slot) >= radius && now.x(slot) <= 1 - radius, "x = " + now.x(slot));
            assertTrue(now.y(slot) >= radius && now.y(slot) <= 1 - radius, "y = " + now.y(slot));
            assertTrue(Float.isFinite(now.vx(slot)) && Float.isFinite(now.vy(slot)), "velocity of " + slot);
        }
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void nothingLeavesTheThesisScene(Supplier<ComputeDevice> device) {
        try (Circles2D world = Scene.THESIS.build(Internals.thesis().device(device.get()), 500)) {
            for (int step = 0; step < 150; step++) {
                world.step();
                checkInside(world);
            }
        }
    }

    /** Much faster than the world is wide, and of every mass: walls hold, nothing is lost to infinity. */
    @ParameterizedTest
    @MethodSource("restitutions")
    void nothingLeavesAtAnySpeed(Supplier<ComputeDevice> device, float restitution) {
        Scene scene = new Scene("fast", 0, -1e6f, restitution, (world, circles) -> {
            SplittableRandom random = new SplittableRandom(5);
            CircleDef def = new CircleDef();
            for (int i = 0; i < circles; i++) {
                def.position((float) random.nextDouble(), (float) random.nextDouble())
                        .radius((float) random.nextDouble(0.005, 0.05))
                        .mass((float) Math.pow(10, random.nextDouble(-9, 9)))
                        .velocity((float) random.nextDouble(-1e9, 1e9), (float) random.nextDouble(-1e9, 1e9));
                world.addCircle(def);
            }
        });
        try (Circles2D world = scene.build(Internals.thesis().device(device.get()), 100)) {
            for (int step = 0; step < 100; step++) {
                world.step();
                checkInside(world);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void hundredCirclesOnOneSpotPart(Supplier<ComputeDevice> device) {
        try (Circles2D world = Internals.thesis().device(device.get()).build()) {
            for (int i = 0; i < 100; i++) {
                world.addCircle(0.5f, 0.5f, 0.02f, 1);
            }
            for (int step = 0; step < 60; step++) {
                world.step();
                checkInside(world);
            }
            Snapshot now = world.snapshot();
            Set<List<Float>> places = new HashSet<>();
            for (int slot = 0; slot < now.count(); slot++) {
                places.add(List.of(now.x(slot), now.y(slot)));
            }
            assertEquals(100, places.size());
        }
    }
}
