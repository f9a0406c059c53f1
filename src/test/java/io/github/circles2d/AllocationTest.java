package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import io.github.circles2d.demo.Scene;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Steps after the first leave no garbage. */
class AllocationTest {
    private static final int STEPS = 1000;
    /** The JVM allocates on its own account now and then, while it compiles: the quietest round counts. */
    private static final int ROUNDS = 3;

    /** Reading from a device makes one small object of JOCL's: once a step of small steps, once in many of the thesis' steps. */
    private static int allowed(Solver solver) {
        return solver == Solver.SMALL_STEPS ? 16 * STEPS : STEPS;
    }

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
            assertTrue(least <= allowed(solver), least + " bytes in " + STEPS + " steps");
        }
    }
}
