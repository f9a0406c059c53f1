package io.github.circles2d.pipeline;

import io.github.circles2d.IndexStrategy;
import java.nio.ByteBuffer;

/** The built-in strategies; each but the grid is the twin of {@code kernels/index_<name>.cl}. */
public abstract class IndexStrategies implements IndexStrategy {
    public static final IndexStrategy FORMULA = new IndexStrategies("formula") {
        @Override
        public long pairAt(long pair, long first, int circles, ByteBuffer table) {
            // counted from the last pair, rows grow by one; a double root of a 64-bit number is at most one row off
            long k = IndexStrategy.pairs(circles) - 1 - pair;
            long row = (long) (Math.sqrt(2.0 * k + 0.25) - 0.5);
            row = triangular(row) > k ? row - 1 : row;
            row = triangular(row + 1) <= k ? row + 1 : row;
            return IndexStrategy.pack((int) (circles - 2L - row), (int) (circles - 1L - (k - triangular(row))));
        }
    };

    public static final IndexStrategy PAIR_TABLE = new IndexStrategies("pair_table") {
        @Override
        public long tableBytes(int circles, long pairs) {
            return Math.multiplyExact(pairs, halves(circles) ? 4L : 8L);
        }

        @Override
        public void fillTable(int circles, long first, long pairs, ByteBuffer table) {
            long pair = FORMULA.pairAt(first, first, circles, table);
            int i = IndexStrategy.first(pair);
            int j = IndexStrategy.second(pair);
            for (int at = 0; at < pairs; at++) {
                if (halves(circles)) {
                    table.putShort(4 * at, (short) i).putShort(4 * at + 2, (short) j);
                } else {
                    table.putInt(8 * at, i).putInt(8 * at + 4, j);
                }
                if (++j == circles) {
                    j = ++i + 1;
                }
            }
        }

        @Override
        public long pairAt(long pair, long first, int circles, ByteBuffer table) {
            int at = (int) (pair - first);
            return halves(circles)
                    ? IndexStrategy.pack(table.getChar(4 * at), table.getChar(4 * at + 2))
                    : IndexStrategy.pack(table.getInt(8 * at), table.getInt(8 * at + 4));
        }
    };

    public static final IndexStrategy ROW_SEARCH = new IndexStrategies("row_search") {
        @Override
        public long tableBytes(int circles, long pairs) {
            return (circles - 1L) * (wide(circles) ? 16 : 8);
        }

        @Override
        public void fillTable(int circles, long first, long pairs, ByteBuffer table) {
            boolean wide = wide(circles);
            long start = 0;
            for (int row = 0; row < circles - 1; row++) {
                long end = start + circles - 2 - row;
                if (wide) {
                    table.putLong(16 * row, start).putLong(16 * row + 8, end);
                } else {
                    table.putInt(8 * row, (int) start).putInt(8 * row + 4, (int) end);
                }
                start = end + 1;
            }
        }

        @Override
        public long pairAt(long pair, long first, int circles, ByteBuffer table) {
            boolean wide = wide(circles);
            int low = 0;
            int high = circles - 2;
            while (low < high) {
                int middle = low + (high - low) / 2;
                if (pair > (wide ? table.getLong(16 * middle + 8) : table.getInt(8 * middle + 4))) {
                    low = middle + 1;
                } else {
                    high = middle;
                }
            }
            long start = wide ? table.getLong(16 * low) : table.getInt(8 * low);
            return IndexStrategy.pack(low, (int) (low + 1 + (pair - start)));
        }
    };

    public static final IndexStrategy FOLDED = new IndexStrategies("folded") {
        @Override
        public long pairAt(long pair, long first, int circles, ByteBuffer table) {
            int odd = circles & 1;
            long width = circles - 1L + odd;
            long line = pair / width;
            int p = (int) line;
            int q = (int) (pair - line * width);
            return q < circles - 1 - p
                    ? IndexStrategy.pack(p, p + 1 + q)
                    : IndexStrategy.pack(circles - 1 - odd - p, q + 1 - odd);
        }
    };

    public static final IndexStrategy GRID = new IndexStrategies("grid") {
        @Override
        public boolean pairwise() {
            return false;
        }

        @Override
        public String kernelSource() {
            return "";
        }

        @Override
        public long pairAt(long pair, long first, int circles, ByteBuffer table) {
            throw new UnsupportedOperationException("grid() does not number the pairs");
        }
    };

    /** Stands for one of the others until a world is built. */
    public static final IndexStrategy AUTO = new IndexStrategies("auto") {
        @Override
        public String kernelSource() {
            throw new UnsupportedOperationException("auto() is another strategy in every world");
        }

        @Override
        public long pairAt(long pair, long first, int circles, ByteBuffer table) {
            throw new UnsupportedOperationException("auto() is another strategy in every world");
        }
    };

    private final String name;

    private IndexStrategies(String name) {
        this.name = name;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public String kernelSource() {
        return KernelSources.read("index_" + name + ".cl");
    }

    @Override
    public String toString() {
        return name;
    }

    /** Whether pair indices need 64 bits; the kernels' {@code C2D_WIDE}. */
    public static boolean wide(int circles) {
        return IndexStrategy.pairs(circles) > Integer.MAX_VALUE;
    }

    /** Whether half an int holds the number of a circle. */
    private static boolean halves(int circles) {
        return circles <= 1 << 16;
    }

    private static long triangular(long row) {
        return row * (row + 1) / 2;
    }
}
