package io.github.circles2d.host;

import io.github.circles2d.CapacityException;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.pipeline.Slices;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** The pairs of circles as the index strategy numbers them. */
final class PairSource {
    /** Something done with a pair. */
    interface PairAction {
        void accept(int i, int j);
    }

    /** Slices of 2^27 pairs: a table of all pairs is then, at 8 bytes a pair, as large as a Java buffer can be. */
    private static final long PAIRS_PER_SLICE = 1L << 27;

    private final WorldConfig config;
    private Slices slices = Slices.NONE;
    private ByteBuffer[] tables = {};

    PairSource(WorldConfig config) {
        this.config = config;
    }

    /** The pairs as they are now, of so many circles as {@link #prepare} was last given. */
    Slices slices() {
        return slices;
    }

    /** Makes the look-up tables for so many circles, unless they are there. */
    Slices prepare(int circles) {
        if (slices.circles() == circles) {
            return slices;
        }
        Slices wanted = Slices.of(circles, config.pairsPerSlice() > 0 ? config.pairsPerSlice() : PAIRS_PER_SLICE);
        release();
        tables = new ByteBuffer[wanted.count()];
        for (int s = 0; s < wanted.count(); s++) {
            long bytes = config.strategy().tableBytes(circles, wanted.pairs(s));
            if (bytes > Integer.MAX_VALUE - 64) {
                throw new CapacityException("the table of strategy "
                        + config.strategy().name() + " for " + circles + " circles takes " + bytes
                        + " bytes; plain Java has room for " + (Integer.MAX_VALUE - 64));
            }
            try {
                tables[s] = ByteBuffer.allocate((int) bytes).order(ByteOrder.nativeOrder());
            } catch (OutOfMemoryError e) {
                release();
                throw noMemory(wanted, s);
            }
            config.strategy().fillTable(circles, wanted.first(s), wanted.pairs(s), tables[s]);
        }
        slices = wanted;
        return slices;
    }

    /** Gives the memory of the tables back. */
    void release() {
        slices = Slices.NONE;
        tables = new ByteBuffer[0];
    }

    /** What to throw where Java has no memory for a slice: its table, and its part of the triangle if there is one. */
    CapacityException noMemory(Slices wanted, int slice) {
        long pairs = wanted.pairs(slice);
        long bytes = config.strategy().tableBytes(wanted.circles(), pairs) + (config.triangle() ? 8 * pairs : 0);
        return new CapacityException("no memory for the pairs of " + wanted.circles() + " circles: " + wanted.count()
                + " slices of " + bytes + " bytes");
    }

    /** The pair of an index in a slice, which begins with index {@code first}; packed. */
    long pairAt(long pair, long first, int slice) {
        return config.strategy().pairAt(pair, first, slices.circles(), tables[slice]);
    }

    /** Every pair of so many circles. */
    void forEach(int circles, PairAction action) {
        prepare(circles);
        for (int s = 0; s < slices.count(); s++) {
            long first = slices.first(s);
            for (long pair = first; pair < first + slices.pairs(s); pair++) {
                long packed = pairAt(pair, first, s);
                action.accept(IndexStrategy.first(packed), IndexStrategy.second(packed));
            }
        }
    }
}
