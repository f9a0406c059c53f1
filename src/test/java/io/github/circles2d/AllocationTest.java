package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import io.github.circles2d.demo.Scene;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Steps after the first leave no garbage. */
class AllocationTest {
    private static final int STEPS = 1000;
    private static final int FRAMES = 20;
    /** The JVM allocates on its own account now and then, while it compiles: the quietest round counts. */
    private static final int ROUNDS = 3;

    static List<Arguments> worlds() {
        List<Arguments> all = new ArrayList<>();
        TestDevices.both().forEach(device -> {
            for (int smallWorld : new int[] {0, 4096}) {
                all.add(Arguments.of(device, Solver.SMALL_STEPS, CollisionStore.COMPACT, smallWorld));
                all.add(Arguments.of(device, Solver.IMPULSE, CollisionStore.COMPACT, smallWorld));
                all.add(Arguments.of(device, Solver.IMPULSE, CollisionStore.TRIANGLE, smallWorld));
            }
        });
        return all;
    }

    @ParameterizedTest
    @MethodSource("worlds")
    void stepsAllocateNothing(Supplier<ComputeDevice> device, Solver solver, CollisionStore store, int smallWorld) {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long self = Thread.currentThread().getId();
        WorldBuilder builder = Internals.thesisBuilder()
                .device(device.get())
                .solver(solver)
                .collisionStore(store)
                .smallWorld(smallWorld);
        try (Circles2D world = Scene.THESIS.build(builder, 200)) {
            world.step();
            long least = Long.MAX_VALUE;
            for (int round = 0; round < ROUNDS; round++) {
                long before = threads.getThreadAllocatedBytes(self);
                for (int step = 0; step < STEPS; step++) {
                    world.step();
                }
                least = Math.min(least, threads.getThreadAllocatedBytes(self) - before);
            }
            assertTrue(least <= STEPS, least + " bytes in " + STEPS + " steps");
        }
    }

    /** One circle is so fast that a step lists the contacts three times, and the last time for less long. */
    @ParameterizedTest
    @CsvSource({"10000, false", "10000, true", "100000, false", "100000, true"})
    void framesAllocateNothing(int circles, boolean background) {
        Circles2D.Builder builder = Circles2D.builder()
                .device(TestDevices.openCl())
                .bounds(0, 0, 2, 1)
                .gravity(0, 0)
                .substeps(8)
                .capacity(circles)
                .background(background);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long self = Thread.currentThread().getId();
        try (Circles2D world = builder.build()) {
            float side = (float) Math.ceil(Math.sqrt(circles));
            for (int i = 1; i < circles; i++) {
                world.addCircle((i % side + 0.5f) / side, ((int) (i / side) + 0.5f) / side, 0.2f / side, 1);
            }
            world.setVelocity(world.addCircle(1.5f, 0.5f, 0.2f / side, 1), 66 * 0.2f / side, 0);
            frame(world);
            frame(world);
            long steps = background ? stepsThread() : self;
            long least = Long.MAX_VALUE;
            long leastOfSteps = Long.MAX_VALUE;
            for (int round = 0; round < ROUNDS; round++) {
                long before = threads.getThreadAllocatedBytes(self);
                long beforeOfSteps = threads.getThreadAllocatedBytes(steps);
                for (int frame = 0; frame < FRAMES; frame++) {
                    world.setVelocity(frame, 0, 0);
                    frame(world);
                }
                least = Math.min(least, threads.getThreadAllocatedBytes(self) - before);
                leastOfSteps = Math.min(leastOfSteps, threads.getThreadAllocatedBytes(steps) - beforeOfSteps);
            }
            assertEquals(0, least, "bytes in " + FRAMES + " frames");
            assertEquals(0, leastOfSteps, "bytes in " + FRAMES + " frames, of the thread that makes the steps");
        }
    }

    /** Circles that bounce without end: the world chooses other substeps in almost every step. */
    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void chosenSubstepsAllocateNothing(Supplier<ComputeDevice> device) {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long self = Thread.currentThread().getId();
        try (Circles2D world =
                Circles2D.builder().device(device.get()).restitution(1).build()) {
            for (int i = 0; i < 100; i++) {
                world.addCircle((i + 0.5f) / 100, 0.9f, 0.002f, 1);
            }
            long least = Long.MAX_VALUE;
            for (int round = 0; round < ROUNDS; round++) {
                long before = threads.getThreadAllocatedBytes(self);
                for (int frame = 0; frame < 2 * FRAMES; frame++) {
                    frame(world);
                }
                least = Math.min(least, threads.getThreadAllocatedBytes(self) - before);
            }
            assertEquals(0, least, "bytes in " + 2 * FRAMES + " frames");
        }
    }

    private static void frame(Circles2D world) {
        world.step();
        Snapshot now = world.snapshot();
        assertTrue(
                now.transforms().limit() == 4 * now.count() && now.velocities().limit() == 2 * now.count());
    }

    private static long stepsThread() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().equals("circles2d steps"))
                .findFirst()
                .orElseThrow()
                .getId();
    }
}
