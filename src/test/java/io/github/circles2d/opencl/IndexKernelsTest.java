package io.github.circles2d.opencl;

import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.IndexStrategy;
import io.github.circles2d.TestDevices;
import io.github.circles2d.pipeline.IndexStrategies;
import io.github.circles2d.pipeline.PairRule;
import java.nio.IntBuffer;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Each strategy's kernel source numbers the pairs 0 <= i < j < n one to one, as the strategy in Java does. */
class IndexKernelsTest {
    private final OpenClDevice device = (OpenClDevice) TestDevices.openClInside();

    private static IndexStrategy strategy(String name) {
        return List.of(
                        IndexStrategy.formula(),
                        IndexStrategy.pairTable(),
                        IndexStrategy.rowSearch(),
                        IndexStrategy.folded())
                .stream()
                .filter(s -> s.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    /** With 64-bit numbers too, where the table does not depend on them. */
    @ParameterizedTest
    @CsvSource({
        "formula, false",
        "formula, true",
        "pair_table, false",
        "pair_table, true",
        "row_search, false",
        "folded, false",
        "folded, true"
    })
    void everyPairOfSmallWorldsComesOnce(String name, boolean wide) {
        IndexStrategy strategy = strategy(name);
        int most = 300;
        try (PairKernel kernel = new PairKernel(device, strategy, wide)) {
            kernel.numbers(PairRule.range(0, IndexStrategy.pairs(most)));
            for (int n = 2; n <= most; n++) {
                int count = (int) IndexStrategy.pairs(n);
                kernel.table(n, 0, count);
                IntBuffer pairs = kernel.pairs(n, 0, count);
                boolean[] seen = new boolean[n * n];
                for (int c = 0; c < count; c++) {
                    int i = pairs.get(2 * c);
                    int j = pairs.get(2 * c + 1);
                    assertNull(PairRule.fault(strategy, n, c, i, j));
                    assertTrue(!seen[i * n + j], strategy + ", n = " + n + ": (" + i + ", " + j + ") comes twice");
                    seen[i * n + j] = true;
                }
            }
        }
    }

    private static void check(PairKernel kernel, IndexStrategy strategy, int n, long first, long[] numbers) {
        kernel.numbers(numbers);
        IntBuffer pairs = kernel.pairs(n, first, numbers.length);
        for (int k = 0; k < numbers.length; k++) {
            assertNull(PairRule.fault(strategy, n, numbers[k], pairs.get(2 * k), pairs.get(2 * k + 1)));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"formula", "row_search", "folded"})
    void largeWorlds(String name) {
        IndexStrategy strategy = strategy(name);
        try (PairKernel narrow = new PairKernel(device, strategy, false);
                PairKernel wide = new PairKernel(device, strategy, true)) {
            for (int n : new int[] {2_117, 5_794, 46_342, 65_536, 65_537, 92_683, 1_000_000}) {
                PairKernel kernel = IndexStrategies.wide(n) ? wide : narrow;
                kernel.table(n, 0, 1);
                check(kernel, strategy, n, 0, PairRule.samples(n, 20_000, n));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {2_117, 5_794, 46_342, 65_537, 92_683, 1_000_000})
    void partsOfThePairTableOfLargeWorlds(int n) {
        IndexStrategy strategy = IndexStrategy.pairTable();
        int part = 20_000;
        long pairs = IndexStrategy.pairs(n);
        try (PairKernel kernel = new PairKernel(device, strategy, IndexStrategies.wide(n))) {
            for (long first : new long[] {0, PairRule.rowStart(n, n / 3) - 7, pairs / 2, pairs - part}) {
                kernel.table(n, first, part);
                check(kernel, strategy, n, first, PairRule.range(first, part));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"formula", "folded"})
    void mostCirclesThatAnIntCounts(String name) {
        IndexStrategy strategy = strategy(name);
        try (PairKernel kernel = new PairKernel(device, strategy, true)) {
            check(kernel, strategy, Integer.MAX_VALUE, 0, PairRule.samples(Integer.MAX_VALUE, 100_000, 1));
        }
    }
}
