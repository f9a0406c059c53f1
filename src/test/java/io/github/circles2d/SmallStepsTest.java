package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.demo.Scene;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What {@link Solver#SMALL_STEPS} promises of its worlds; on the host, the OpenCL device has the same bits. */
class SmallStepsTest {
    private static Circles2D.Builder builder() {
        return Circles2D.builder()
                .device(ComputeDevice.host())
                .solver(Solver.SMALL_STEPS)
                .indexStrategy(IndexStrategy.grid());
    }

    @Test
    void aPileStandsAndDoesNotSinkIntoItself() {
        try (Circles2D world = Scene.PILE.build(builder().substeps(16), 2000)) {
            world.step(900);
            StepStats stats = world.stats();
            assertTrue(stats.contacts() > 3000, stats.toString());
            assertTrue(stats.meanOverlap() <= 0.005, stats.toString());
            assertTrue(stats.maxOverlap() <= 0.02, stats.toString());
            assertTrue(stats.maxSpeed() < 0.01, stats.toString());
            assertEquals(0, stats.outside(), stats.toString());
        }
    }

    @Test
    void aPileOfManySizesStandsToo() {
        try (Circles2D world = Scene.PEBBLES.build(builder(), 1000)) {
            world.step(600);
            StepStats stats = world.stats();
            assertTrue(stats.meanOverlap() <= 0.01, stats.toString());
            assertTrue(stats.maxOverlap() <= 0.1, stats.toString());
            assertEquals(0, stats.outside(), stats.toString());
        }
    }

    @Test
    void aGasKeepsItsEnergy() {
        try (Circles2D world = Scene.GAS.build(builder(), 1000)) {
            world.step();
            double before = world.stats().kineticEnergy();
            world.step(600);
            assertEquals(1, world.stats().kineticEnergy() / before, 1e-4);
            assertEquals(0, world.stats().outside());
        }
    }

    @Test
    void momentumStaysWhereNothingTouchesAWall() {
        SplittableRandom random = new SplittableRandom(1);
        try (Circles2D world = builder().gravity(0, 0).bounds(-50, -50, 50, 50).build()) {
            double x = 0;
            double y = 0;
            double size = 0;
            for (int i = 0; i < 200; i++) {
                float mass = 1 + 9 * (float) random.nextDouble();
                float px = (float) random.nextDouble(-1, 1);
                float py = (float) random.nextDouble(-1, 1);
                // all towards the middle
                world.addCircle(new CircleDef()
                        .position(px, py)
                        .radius(0.02f)
                        .mass(mass)
                        .velocity(-px, 0.1f - py));
                x -= mass * px;
                y += mass * (0.1f - py);
                size += mass * Math.hypot(px, 0.1f - py);
            }
            world.step(240);
            assertEquals(x, world.stats().momentumX(), 1e-5 * size);
            assertEquals(y, world.stats().momentumY(), 1e-5 * size);
        }
    }

    @ParameterizedTest
    @ValueSource(floats = {0, 0.5f, 1})
    void aBallBouncesAsHighAsItsRestitutionSays(float restitution) {
        try (Circles2D world = builder()
                .restitution(restitution)
                .timeStep(1f / 240)
                .substeps(4)
                .build()) {
            world.addCircle(0.5f, 0.55f, 0.05f, 1);
            double highest = 0;
            boolean bounced = false;
            for (int step = 0; step < 600; step++) {
                world.step();
                Snapshot now = world.snapshot();
                bounced |= now.vy(0) > 0 || now.y(0) < 0.051f;
                highest = bounced && step > 250 ? Math.max(highest, now.y(0)) : highest;
            }
            assertEquals(0.05 + 0.5 * restitution * restitution, highest, 0.01);
        }
    }

    /** An impulse that is repeated along a normal that has turned would double the energy again and again. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4})
    void farTooFewSubstepsGainNoEnergy(int substeps) {
        try (Circles2D world = Scene.PILE.build(builder().substeps(substeps), 5000)) {
            double before = SmallStepsScenesTest.energy(Scene.PILE, world.snapshot());
            for (int round = 0; round < 8; round++) {
                world.step(15);
                double now = SmallStepsScenesTest.energy(Scene.PILE, world.snapshot());
                assertTrue(now <= before, "round " + round + ": " + now + " of " + before);
            }
        }
    }

    @Test
    void aHeapOnOnePointComesApart() {
        try (Circles2D world = builder().build()) {
            for (int i = 0; i < 300; i++) {
                world.addCircle(0.5f, 0.5f, 0.01f, 1 + i % 7);
            }
            world.step(300);
            StepStats stats = world.stats();
            assertEquals(0, stats.outside(), stats.toString());
            assertTrue(stats.maxOverlap() < 0.05, stats.toString());
        }
    }

    @Test
    void wildNumbersStayInside() {
        SplittableRandom random = new SplittableRandom(3);
        try (Circles2D world = builder().build()) {
            for (int i = 0; i < 300; i++) {
                float speed = (float) Math.pow(10, random.nextDouble(-3, 9));
                world.addCircle(new CircleDef()
                        .position((float) random.nextDouble(), (float) random.nextDouble())
                        .radius((float) Math.pow(10, random.nextDouble(-9, -2)))
                        .mass((float) Math.pow(10, random.nextDouble(-9, 9)))
                        .velocity(random.nextBoolean() ? speed : -speed, random.nextBoolean() ? speed : -speed));
            }
            for (int step = 0; step < 60; step++) {
                world.step();
                assertEquals(0, world.stats().outside(), "step " + step);
            }
        }
    }

    @Test
    void substepsOutOfRangeAreNamed() {
        assertThrows(IllegalArgumentException.class, () -> builder().substeps(-1));
        assertThrows(IllegalArgumentException.class, () -> builder().substeps(513));
    }
}
