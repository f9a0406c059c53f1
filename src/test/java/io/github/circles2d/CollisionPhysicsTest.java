package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Two circles, and one circle and a wall, against the formulas of {@link Solver#IMPULSE}. */
class CollisionPhysicsTest {
    private static final float STEP = 1f / 64;
    private static final double CLOSE = 2e-6;

    private static Circles2D world(ComputeDevice device, float restitution, float gravityY) {
        return Internals.thesis()
                .device(device)
                .timeStep(STEP)
                .gravity(0, gravityY)
                .restitution(restitution)
                .build();
    }

    private static List<Arguments> withRestitutions(float[][] values) {
        List<Arguments> all = new ArrayList<>();
        TestDevices.both().forEach(device -> {
            for (float restitution : new float[] {0, 0.5f, 1}) {
                for (float[] value : values) {
                    all.add(Arguments.of(device, restitution, value[0], value[1]));
                }
            }
        });
        return all;
    }

    static List<Arguments> masses() {
        return withRestitutions(new float[][] {{1, 1}, {1, 9}, {100, 0.01f}});
    }

    @ParameterizedTest
    @MethodSource("masses")
    void twoCirclesCollide(Supplier<ComputeDevice> device, float restitution, float massA, float massB) {
        try (Circles2D world = world(device.get(), restitution, 0)) {
            CircleDef def = new CircleDef().radius(0.05f);
            world.addCircle(def.position(0.40f, 0.48f).velocity(1, 0.25f).mass(massA));
            world.addCircle(def.position(0.48f, 0.52f).velocity(-0.5f, 0.5f).mass(massB));
            world.step();

            double ax = 0.40 + STEP;
            double ay = 0.48 + 0.25 * STEP;
            double bx = 0.48 - 0.5 * STEP;
            double by = 0.52 + 0.5 * STEP;
            double distance = Math.hypot(bx - ax, by - ay);
            double nx = (bx - ax) / distance;
            double ny = (by - ay) / distance;
            double depth = 0.1 - distance;
            double whole = 1.0 / massA + 1.0 / massB;
            double shareA = 1.0 / massA / whole;
            double approach = (1 + 0.5) * nx + (0.25 - 0.5) * ny;
            double impulse = -(1 + restitution) * approach / whole;
            assertTrue(depth > 0.01 && approach > 0.5, "no collision");

            Snapshot now = world.snapshot();
            assertEquals(ax - depth * shareA * nx, now.x(0), CLOSE);
            assertEquals(ay - depth * shareA * ny, now.y(0), CLOSE);
            assertEquals(bx + depth * (1 - shareA) * nx, now.x(1), CLOSE);
            assertEquals(by + depth * (1 - shareA) * ny, now.y(1), CLOSE);
            assertEquals(1 + impulse / massA * nx, now.vx(0), CLOSE);
            assertEquals(0.25 + impulse / massA * ny, now.vy(0), CLOSE);
            assertEquals(-0.5 - impulse / massB * nx, now.vx(1), CLOSE);
            assertEquals(0.5 - impulse / massB * ny, now.vy(1), CLOSE);
            assertEquals(1, world.stats().contacts());
            assertEquals(depth / 0.05, world.stats().maxOverlap(), 1e-4);
        }
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void circlesThatPartGetNoImpulse(Supplier<ComputeDevice> device) {
        try (Circles2D world = world(device.get(), 0.5f, 0)) {
            CircleDef def = new CircleDef().radius(0.05f);
            world.addCircle(def.position(0.45f, 0.5f).velocity(-0.25f, 0.125f));
            world.addCircle(def.position(0.50f, 0.5f).velocity(0.5f, -0.125f));
            world.step();
            Snapshot now = world.snapshot();
            assertEquals(1, world.stats().contacts());
            assertEquals(-0.25f, now.vx(0));
            assertEquals(0.125f, now.vy(0));
            assertEquals(0.5f, now.vx(1));
            assertEquals(-0.125f, now.vy(1));
            assertEquals(0.1, Math.hypot(now.x(1) - now.x(0), now.y(1) - now.y(0)), CLOSE);
        }
    }

    static List<Arguments> walls() {
        return withRestitutions(new float[][] {{-1, 0}, {1, 0}, {0, -1}, {0, 1}});
    }

    /** (wallX, wallY) points to the wall; gravity pulls down in all four cases. */
    @ParameterizedTest
    @MethodSource("walls")
    void circleMeetsAWall(Supplier<ComputeDevice> device, float restitution, float wallX, float wallY) {
        try (Circles2D world = world(device.get(), restitution, -2)) {
            float speed = 3;
            float along = 0.25f;
            float x = 0.5f + 0.43f * wallX;
            float y = 0.5f + 0.43f * wallY;
            float vx = speed * wallX + along * Math.abs(wallY);
            float vy = speed * wallY + along * Math.abs(wallX);
            world.addCircle(new CircleDef().position(x, y).radius(0.05f).velocity(vx, vy));
            world.step();
            Snapshot now = world.snapshot();
            double gain = -2.0 * STEP;
            double freeY = y + vy * STEP + gain * STEP / 2;
            checkAxis(x + vx * STEP, vx, wallX, restitution, now.x(0), now.vx(0));
            checkAxis(freeY, vy + gain, wallY, restitution, now.y(0), now.vy(0));
        }
    }

    /** One axis after a free flight that may have gone beyond the wall on that side. */
    private static void checkAxis(
            double free, double velocity, float wall, float restitution, float position, float newVelocity) {
        double limit = 0.5 + 0.45 * wall;
        boolean hit = wall != 0;
        assertTrue(!hit || (free - limit) * wall > 0.01, "the wall is not reached");
        assertEquals(hit ? limit - restitution * (free - limit) : free, position, CLOSE);
        assertEquals(hit ? -restitution * velocity : velocity, newVelocity, CLOSE);
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void circleThatLeavesAWallKeepsItsVelocity(Supplier<ComputeDevice> device) {
        try (Circles2D world = world(device.get(), 0.5f, 0)) {
            world.addCircle(new CircleDef().position(0, 1).radius(0.1f).mass(1).velocity(0.25f, -0.25f));
            world.step();
            Snapshot now = world.snapshot();
            assertEquals(0.25f, now.vx(0));
            assertEquals(-0.25f, now.vy(0));
            assertTrue(now.x(0) >= 0.1f && now.y(0) <= 0.9f, now.x(0) + ", " + now.y(0));
        }
    }

    /** A circle pushed into a wall stops there. */
    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void lightCircleBetweenAHeavyOneAndAWall(Supplier<ComputeDevice> device) {
        try (Circles2D world = world(device.get(), 0, 0)) {
            world.addCircle(0.05f, 0.5f, 0.05f, 0.001f);
            world.addCircle(0.10f, 0.5f, 0.05f, 1000);
            world.step();
            assertEquals(1, world.stats().contacts());
            assertEquals(0.05f, world.snapshot().x(0));
            assertEquals(0.10, world.snapshot().x(1), CLOSE);
        }
    }
}
