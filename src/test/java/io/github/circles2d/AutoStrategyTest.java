package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.demo.Scene;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** {@link IndexStrategy#auto()}: a choice, kept, that never changes the result. */
class AutoStrategyTest {
    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void theChoiceNeverChangesTheHash(Supplier<ComputeDevice> device) {
        for (Solver solver : Solver.values()) {
            assertEquals(
                    hash(device.get(), solver, IndexStrategy.folded()),
                    hash(device.get(), solver, IndexStrategy.auto()),
                    solver.name());
        }
    }

    private static long hash(ComputeDevice device, Solver solver, IndexStrategy strategy) {
        Circles2D.Builder builder =
                Circles2D.builder().device(device).solver(solver).indexStrategy(strategy);
        try (Circles2D world = Scene.PILE.build(builder, 300)) {
            world.step(60);
            return world.stateHash();
        }
    }

    @Test
    void aChoiceIsKeptForWorldsOfAKind() {
        ComputeDevice host = ComputeDevice.host();
        AutoChoice first = AutoChoice.of(host, Solver.SMALL_STEPS, CollisionStore.COMPACT, 600);
        assertSame(first, AutoChoice.of(host, Solver.SMALL_STEPS, CollisionStore.COMPACT, 1000));
        assertNotSame(first, AutoChoice.of(host, Solver.SMALL_STEPS, CollisionStore.COMPACT, 2000));
        assertNotSame(first, AutoChoice.of(host, Solver.IMPULSE, CollisionStore.COMPACT, 600));
    }

    @Test
    void manyCirclesAreNotPairedWithEachOther() {
        ComputeDevice host = ComputeDevice.host();
        assertFalse(AutoChoice.of(host, Solver.IMPULSE, CollisionStore.COMPACT, 20_000)
                .strategy()
                .pairwise());
        assertTrue(AutoChoice.of(host, Solver.IMPULSE, CollisionStore.TRIANGLE, 500)
                .strategy()
                .pairwise());
    }
}
