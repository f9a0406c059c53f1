package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.pipeline.IndexStrategies;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** A world that grows past 2^31 - 1 pairs: the kernels change to 64-bit pair numbers, no pair is missed. */
class ManyPairsTest {
    private static final int CIRCLES = 65_537;
    private static final int SIDE = 257;

    /** Circles that lie beside another: the second by the first. */
    private static final Map<Integer, Integer> BESIDE =
            Map.of(CIRCLES - 1, 0, 2, 1, 32_769, 32_768, 65_535, 65_533, 50_000, 7);

    private static float x(int i) {
        return (i % SIDE + 0.5f) / SIDE;
    }

    private static float y(int i) {
        return (i / SIDE + 0.5f) / SIDE;
    }

    @Test
    void contactsOfALatticeWithFewNeighbours() {
        assertTrue(IndexStrategies.wide(CIRCLES) && !IndexStrategies.wide(CIRCLES - 1));
        try (Circles2D world =
                Internals.thesis().device(TestDevices.openCl()).gravity(0, 0).build()) {
            for (int i = 0; i < CIRCLES; i++) {
                if (i == 1000) {
                    world.step();
                    assertEquals(1, world.stats().contacts(), "32-bit numbers");
                    // on its way it meets nothing
                    world.setVelocity(2, 0.06f, 0);
                }
                int place = BESIDE.getOrDefault(i, i);
                world.addCircle(x(place) + (place == i ? 0 : 0.0015f), y(place), 0.001f, 1);
            }
            world.step();
            // circle 2 has left circle 1 before
            assertEquals(BESIDE.size() - 1, world.stats().contacts());
            Snapshot now = world.snapshot();
            for (int i = 0; i < CIRCLES; i++) {
                float moved = BESIDE.containsKey(i) ? 0.00175f : BESIDE.containsValue(i) ? -0.00025f : 0;
                moved += i == 2 ? 0.001f : 0;
                assertEquals(x(BESIDE.getOrDefault(i, i)) + moved, now.x(i), 1e-6, "circle " + i);
                assertEquals(y(BESIDE.getOrDefault(i, i)), now.y(i), 1e-6, "circle " + i);
            }
        }
    }
}
