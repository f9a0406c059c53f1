package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;

import io.github.circles2d.demo.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The thesis' scene ends in the same bits, whatever computes it and however. */
class SameBitsTest {
    private static final int CIRCLES = 1000;
    private static final int STEPS = 300;

    /** What 300 steps of 1,000 circles end in, on every machine. It changes with the solver or the scene alone. */
    private static final long EXPECTED = 0x43d45cf2be1adc44L;

    static List<Arguments> combinations() {
        List<Arguments> all = new ArrayList<>();
        TestDevices.both().forEach(device -> {
            for (IndexStrategy strategy : List.of(
                    IndexStrategy.formula(),
                    IndexStrategy.pairTable(),
                    IndexStrategy.rowSearch(),
                    IndexStrategy.folded())) {
                for (CollisionStore store : CollisionStore.values()) {
                    all.add(Arguments.of(device, strategy, store));
                }
            }
        });
        return all;
    }

    private static void check(WorldBuilder builder) {
        try (Circles2D world = Scene.THESIS.build(builder, CIRCLES)) {
            world.step(STEPS);
            assertEquals(Long.toHexString(EXPECTED), Long.toHexString(world.stateHash()));
        }
    }

    @ParameterizedTest
    @MethodSource("combinations")
    void strategiesStoresAndDevices(Supplier<ComputeDevice> device, IndexStrategy strategy, CollisionStore store) {
        check(Internals.thesisBuilder()
                .device(device.get())
                .indexStrategy(strategy)
                .collisionStore(store));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 7, 64, 256})
    void workGroups(int workGroup) {
        check(Internals.thesisBuilder().device(TestDevices.openCl()).workGroup(workGroup));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 7, 64})
    void workGroupsOfALaunchAColour(int workGroup) {
        check(Internals.thesisBuilder()
                .device(TestDevices.openCl())
                .workGroup(workGroup)
                .smallWorld(0));
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void slices(Supplier<ComputeDevice> device) {
        check(Internals.thesisBuilder()
                .device(device.get())
                .indexStrategy(IndexStrategy.pairTable())
                .collisionStore(CollisionStore.TRIANGLE)
                .pairsPerSlice(99_991));
    }

    /** A call a step, with a look at the world now and then, is the same as one call. */
    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void stepsOneByOne(Supplier<ComputeDevice> device) {
        try (Circles2D world = Scene.THESIS.build(Internals.thesisBuilder().device(device.get()), CIRCLES)) {
            for (int step = 0; step < STEPS; step++) {
                world.step();
                if (step % 50 == 0) {
                    assertEquals(step + 1, world.stats().steps());
                }
            }
            assertEquals(Long.toHexString(EXPECTED), Long.toHexString(world.stateHash()));
        }
    }
}
