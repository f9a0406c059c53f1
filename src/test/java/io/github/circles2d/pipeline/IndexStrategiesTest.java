package io.github.circles2d.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.IndexStrategy;
import java.math.BigInteger;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Each strategy in Java numbers the pairs 0 <= i < j < n one to one. */
class IndexStrategiesTest {
    static List<IndexStrategy> strategies() {
        return List.of(
                IndexStrategy.formula(), IndexStrategy.pairTable(), IndexStrategy.rowSearch(), IndexStrategy.folded());
    }

    private static ByteBuffer table(IndexStrategy strategy, int n, long first, long pairs) {
        ByteBuffer table = ByteBuffer.allocate(Math.toIntExact(strategy.tableBytes(n, pairs)))
                .order(ByteOrder.nativeOrder());
        strategy.fillTable(n, first, pairs, table);
        return table;
    }

    private static void check(IndexStrategy strategy, int n, long first, ByteBuffer table, long[] numbers) {
        for (long c : numbers) {
            long pair = strategy.pairAt(c, first, n, table);
            assertNull(PairRule.fault(strategy, n, c, IndexStrategy.first(pair), IndexStrategy.second(pair)));
        }
    }

    @ParameterizedTest
    @MethodSource("strategies")
    void everyPairOfSmallWorldsComesOnce(IndexStrategy strategy) {
        for (int n = 2; n <= 300; n++) {
            int pairs = (int) IndexStrategy.pairs(n);
            ByteBuffer table = table(strategy, n, 0, pairs);
            boolean[] seen = new boolean[n * n];
            for (int c = 0; c < pairs; c++) {
                long pair = strategy.pairAt(c, 0, n, table);
                int i = IndexStrategy.first(pair);
                int j = IndexStrategy.second(pair);
                assertNull(PairRule.fault(strategy, n, c, i, j));
                assertTrue(!seen[i * n + j], strategy + ", n = " + n + ": (" + i + ", " + j + ") comes twice");
                seen[i * n + j] = true;
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {2_117, 5_794, 46_342, 65_537, 92_683, 1_000_000})
    void largeWorlds(int n) {
        for (IndexStrategy strategy :
                List.of(IndexStrategy.formula(), IndexStrategy.rowSearch(), IndexStrategy.folded())) {
            check(strategy, n, 0, table(strategy, n, 0, 1), PairRule.samples(n, 2_000, n));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {2_117, 5_794, 46_342, 65_537, 92_683, 1_000_000})
    void partsOfThePairTableOfLargeWorlds(int n) {
        IndexStrategy strategy = IndexStrategy.pairTable();
        int part = 20_000;
        long pairs = IndexStrategy.pairs(n);
        for (long first : new long[] {0, PairRule.rowStart(n, n / 3) - 7, pairs / 2, pairs - part}) {
            check(strategy, n, first, table(strategy, n, first, part), PairRule.range(first, part));
        }
    }

    @Test
    void mostCirclesThatAnIntCounts() {
        int n = Integer.MAX_VALUE;
        for (IndexStrategy strategy : List.of(IndexStrategy.formula(), IndexStrategy.folded())) {
            check(strategy, n, 0, ByteBuffer.allocate(0), PairRule.samples(n, 20_000, 1));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 46_341, 65_536, 65_537, 92_683, Integer.MAX_VALUE})
    void pairsAreCountedExactly(int n) {
        BigInteger pairs = PairRule.exactPairs(n);
        assertEquals(pairs.longValueExact(), IndexStrategy.pairs(n));
        assertEquals(pairs.bitLength() > 31, IndexStrategies.wide(n));
    }

    @Test
    void packedPairsComeBack() {
        for (int i : new int[] {0, 1, 65_536, Integer.MAX_VALUE - 1}) {
            for (int j : new int[] {1, 65_537, Integer.MAX_VALUE}) {
                long packed = IndexStrategy.pack(i, j);
                assertEquals(i, IndexStrategy.first(packed));
                assertEquals(j, IndexStrategy.second(packed));
            }
        }
    }
}
