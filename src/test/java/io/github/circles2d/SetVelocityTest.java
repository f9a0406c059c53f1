package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Of a large world only what has changed goes to the device, and all of that. */
class SetVelocityTest {
    private static final int CIRCLES = 60_000;
    private static final int COLUMNS = 300;

    /** Circles apart from each other and at rest, some of which are set off before each of some steps. Their hashes. */
    private static List<Long> hashes(ComputeDevice device, Solver solver, boolean background) {
        List<Long> hashes = new ArrayList<>();
        SplittableRandom random = new SplittableRandom(7);
        try (Circles2D world = Circles2D.builder()
                .device(device)
                .solver(solver)
                .substeps(2)
                .gravity(0, 0)
                .background(background)
                .capacity(CIRCLES)
                .build()) {
            for (int i = 0; i < CIRCLES; i++) {
                world.addCircle((1 + i % COLUMNS) / 301f, (1 + i / COLUMNS) / 301f, 0.0005f, 1 + i * 7919 % 13);
            }
            for (int step = 0; step < 6; step++) {
                world.step();
                int[] which = random.ints(step, 0, CIRCLES).toArray();
                for (int circle : which) {
                    float y = world.snapshot().y(circle);
                    world.setVelocity(circle, 0, 0.03f);
                    world.step();
                    Snapshot now = world.snapshot();
                    assertEquals(0.03f, now.vy(circle));
                    assertEquals(y + 0.03f / 60, now.y(circle), 1e-6f);
                    world.setVelocity(circle, 0, 0);
                }
                // those of the last circle and the first are far apart, one more has come
                world.setVelocity(0, 0.01f, step);
                world.setVelocity(CIRCLES - 1, -0.01f, step);
                hashes.add(world.stateHash());
                if (step == 3) {
                    world.addCircle(0.5f / 301, 0.5f / 301, 0.0005f, 1);
                }
            }
            // fast ones hit others, and masses count
            random.ints(200, 0, CIRCLES).forEach(circle -> world.setVelocity(circle, 0.3f, 0.02f));
            world.step(10);
            hashes.add(world.stateHash());
        }
        return hashes;
    }

    /** What is looked at, and what was set and then set again, leaves no trace in how a step is cut. */
    @Test
    void whatWasSetBeforeDoesNotCount() {
        for (boolean background : new boolean[] {false, true}) {
            for (ComputeDevice device : List.of(ComputeDevice.host(), TestDevices.openCl())) {
                assertEquals(setTwice(device, background, false), setTwice(device, background, true));
            }
        }
    }

    private static long setTwice(ComputeDevice device, boolean background, boolean looks) {
        try (Circles2D world =
                Circles2D.builder().device(device).background(background).build()) {
            for (int i = 0; i < 20; i++) {
                world.addCircle(0.1f + 0.04f * i, 0.3f, 0.019f, 1);
            }
            for (int step = 0; step < 2; step++) {
                world.setVelocity(3, 200, 0);
                if (looks) {
                    world.stats();
                }
                world.setVelocity(3, 0, 0.01f);
                world.step(2);
            }
            return world.stateHash();
        }
    }

    @Test
    void whatIsSetIsWhatMoves() {
        for (Solver solver : Solver.values()) {
            List<Long> expected = hashes(ComputeDevice.host(), solver, false);
            assertEquals(expected, hashes(TestDevices.openCl(), solver, false), solver.name());
            assertEquals(expected, hashes(TestDevices.openCl(), solver, true), solver + ", in the background");
        }
    }
}
