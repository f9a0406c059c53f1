package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;

import io.github.circles2d.demo.Scene;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** A strategy that is not built in plugs in and changes nothing but the order that pairs are looked at in. */
class UserStrategyTest {
    private static final int CIRCLES = 200;
    private static final int STEPS = 30;

    /** Column by column: (0, 1), (0, 2), (1, 2), (0, 3), ... */
    private static final class Columns implements IndexStrategy {
        @Override
        public String name() {
            return "columns";
        }

        @Override
        public String kernelSource() {
            return """
                    static int2 c2d_pair_at(c2d_index pair, c2d_index first, int circles, __global const int2 *table) {
                        int j = 1;
                        while ((c2d_index)(j + 1) * j / 2 <= pair) {
                            j++;
                        }
                        return (int2)((int)(pair - (c2d_index)j * (j - 1) / 2), j);
                    }
                    """;
        }

        @Override
        public long pairAt(long pair, long first, int circles, ByteBuffer table) {
            int j = 1;
            while ((j + 1L) * j / 2 <= pair) {
                j++;
            }
            return IndexStrategy.pack((int) (pair - j * (j - 1L) / 2), j);
        }
    }

    /** From the last pair to the first, from a table of 16-bit numbers. */
    private static final class Backwards implements IndexStrategy {
        @Override
        public String name() {
            return "backwards";
        }

        @Override
        public String kernelSource() {
            return """
                    static int2 c2d_pair_at(c2d_index pair, c2d_index first, int circles, __global const int2 *table) {
                        __global const ushort2 *pairs = (__global const ushort2 *)table;
                        return convert_int2(pairs[pair - first]);
                    }
                    """;
        }

        @Override
        public long tableBytes(int circles, long pairs) {
            return 4 * pairs;
        }

        @Override
        public void fillTable(int circles, long first, long pairs, ByteBuffer table) {
            long number = IndexStrategy.pairs(circles);
            for (int i = 0; i < circles; i++) {
                for (int j = i + 1; j < circles; j++) {
                    long at = --number - first;
                    if (at >= 0 && at < pairs) {
                        table.putShort((int) (4 * at), (short) i).putShort((int) (4 * at) + 2, (short) j);
                    }
                }
            }
        }

        @Override
        public long pairAt(long pair, long first, int circles, ByteBuffer table) {
            int at = (int) (4 * (pair - first));
            return IndexStrategy.pack(table.getShort(at) & 0xFFFF, table.getShort(at + 2) & 0xFFFF);
        }
    }

    static List<Arguments> worlds() {
        List<Arguments> all = new ArrayList<>();
        for (IndexStrategy strategy : new IndexStrategy[] {new Columns(), new Backwards()}) {
            for (CollisionStore store : CollisionStore.values()) {
                for (int pairsPerSlice : new int[] {0, 5_003}) {
                    all.add(Arguments.of(strategy.name(), strategy, store, pairsPerSlice));
                }
            }
        }
        return all;
    }

    @ParameterizedTest(name = "{0}, {2}, {3}")
    @MethodSource("worlds")
    void givesTheSameBits(String name, IndexStrategy strategy, CollisionStore store, int pairsPerSlice) {
        long expected = hash(new WorldBuilder().device(ComputeDevice.host()));
        assertEquals(expected, hash(builder(strategy, store, pairsPerSlice).device(ComputeDevice.host())), "host");
        assertEquals(expected, hash(builder(strategy, store, pairsPerSlice).device(TestDevices.openCl())), "OpenCL");
    }

    private static WorldBuilder builder(IndexStrategy strategy, CollisionStore store, int pairsPerSlice) {
        return new WorldBuilder().indexStrategy(strategy).collisionStore(store).pairsPerSlice(pairsPerSlice);
    }

    private static long hash(Circles2D.Builder builder) {
        try (Circles2D world = Scene.THESIS.build(builder, CIRCLES)) {
            world.step(STEPS);
            return world.stateHash();
        }
    }
}
