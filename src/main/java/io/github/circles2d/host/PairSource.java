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

    /** Slices of 2^27 pairs: a table of all pairs is then as large as a Java buffer can be. */
    private static final long PAIRS_PER_SLICE = 1L << 27;

    private final WorldConfig config;
    private Slices slices = Slices.NONE;
    private ByteBuffer[] tables = {};

    PairSource(WorldConfig config) {
        this.config = config;
    }

    private void prepare(int circles) {
        Slices wanted = Slices.of(circles, config.pairsPerSlice() > 0 ? config.pairsPerSlice() : PAIRS_PER_SLICE);
        slices = Slices.NONE;
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
                tables = new ByteBuffer[0];
                throw new CapacityException("no memory for the pairs of " + circles + " circles: " + wanted.count()
                        + " slices of " + bytes + " bytes");
            }
            config.strategy().fillTable(circles, wanted.first(s), wanted.pairs(s), tables[s]);
        }
        slices = wanted;
    }

    /** Every pair of so many circles. */
    void forEach(int circles, PairAction action) {
        if (slices.circles() != circles) {
            prepare(circles);
        }
        for (int s = 0; s < slices.count(); s++) {
            long first = slices.first(s);
            for (long pair = first; pair < first + slices.pairs(s); pair++) {
                long packed = config.strategy().pairAt(pair, first, circles, tables[s]);
                action.accept(IndexStrategy.first(packed), IndexStrategy.second(packed));
            }
        }
    }
}
