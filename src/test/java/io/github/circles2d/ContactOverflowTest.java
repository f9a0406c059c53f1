package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.pipeline.Tuning;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** More contacts than a world has room for: the step is done again with more room, and nothing is lost. */
class ContactOverflowTest {
    private static final int CIRCLES = 300;
    private static final int MEET = 5;

    private static Circles2D heap(ComputeDevice device, CollisionStore store, int smallWorld) {
        Circles2D world = Internals.thesisBuilder()
                .device(device)
                .collisionStore(store)
                .smallWorld(smallWorld)
                .gravity(0, -0.5f)
                .build();
        for (int i = 0; i < CIRCLES; i++) {
            world.addCircle(0.5f, 0.5f, 0.1f, 1 + i % 7);
        }
        return world;
    }

    @ParameterizedTest
    @CsvSource({"COMPACT, 0", "COMPACT, 4096", "TRIANGLE, 0", "TRIANGLE, 4096"})
    void stepsQueuedAtOnce(CollisionStore store, int smallWorld) {
        long pairs = IndexStrategy.pairs(CIRCLES);
        assertTrue(pairs > 10L * (Tuning.CONTACTS_PER_CIRCLE * CIRCLES + Tuning.FIRST_CONTACTS));
        try (Circles2D device = heap(TestDevices.openCl(), store, smallWorld);
                Circles2D host = heap(ComputeDevice.host(), store, smallWorld)) {
            device.step(1);
            host.step(1);
            assertEquals(pairs, device.stats().contacts());
            assertEquals(host.stateHash(), device.stateHash());
        }
        try (Circles2D device = heap(TestDevices.openCl(), store, smallWorld);
                Circles2D host = heap(ComputeDevice.host(), store, smallWorld)) {
            device.step(7);
            host.step(7);
            assertEquals(host.stateHash(), device.stateHash());
            assertEquals(7, device.stats().steps());
            assertEquals(host.stats().contacts(), device.stats().contacts());
        }
    }

    /** Circles that meet in step 5, all of them: the room runs out in the middle of a queue of steps. */
    @ParameterizedTest
    @CsvSource({"COMPACT, 0", "COMPACT, 4096", "TRIANGLE, 0", "TRIANGLE, 4096"})
    void roomRunsOutInTheMiddleOfAQueue(CollisionStore store, int smallWorld) {
        try (Circles2D device = gathering(TestDevices.openCl(), store, smallWorld);
                Circles2D host = gathering(ComputeDevice.host(), store, smallWorld)) {
            host.step(MEET - 1);
            assertEquals(0, host.stats().contacts());
            host.step();
            assertEquals(IndexStrategy.pairs(CIRCLES), host.stats().contacts());
            host.step(MEET);
            device.step(2 * MEET);
            assertEquals(host.stateHash(), device.stateHash());
            assertEquals(host.stats().contacts(), device.stats().contacts());
            assertEquals(2 * MEET, device.stats().steps());
        }
    }

    private static Circles2D gathering(ComputeDevice device, CollisionStore store, int smallWorld) {
        Circles2D world = Internals.thesisBuilder()
                .device(device)
                .collisionStore(store)
                .smallWorld(smallWorld)
                .bounds(-10, -10, 10, 10)
                .gravity(0, 0)
                .restitution(0)
                .build();
        SplittableRandom random = new SplittableRandom(7);
        CircleDef def = new CircleDef();
        int side = 20;
        for (int i = 0; i < CIRCLES; i++) {
            // a step's way from the middle; neighbours are further apart than they are wide
            float x = -1.9f + 3.8f * (i % side) / (side - 1);
            float y = -1.9f + 3.8f * (i / side) / (side - 1);
            def.position(MEET * x, MEET * y)
                    .velocity(-60 * x, -60 * y)
                    .radius(0.09f + 0.005f * (float) random.nextDouble());
            world.addCircle(def);
        }
        return world;
    }
}
