package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Slices;
import io.github.circles2d.pipeline.WorldConfig;
import java.util.ArrayList;
import java.util.List;

/** The index strategy's look-up tables for the circles of a world, in slices. */
final class PairTables {
    /** A part of the pairs. */
    record Slice(long first, long pairs, DeviceBuffer table) {}

    private final Session session;
    private final WorldConfig config;
    private final List<Slice> slices = new ArrayList<>();
    private int circles = -1;

    PairTables(Session session, WorldConfig config) {
        this.session = session;
        this.config = config;
    }

    /** The slices for so many circles, small enough for the triangle where there is one. */
    List<Slice> slices(int count) {
        if (circles != count) {
            close();
            Slices cut = Slices.of(config, count, session.device.maxBuffer, config.triangle());
            try {
                for (int s = 0; s < cut.count(); s++) {
                    slices.add(slice(count, cut.first(s), cut.pairs(s)));
                }
            } catch (RuntimeException e) {
                // the caller may try again with fewer circles, and needs the room
                close();
                throw e;
            }
            circles = count;
        }
        return slices;
    }

    /** Gives the room of the tables back. */
    void close() {
        circles = -1;
        slices.forEach(slice -> slice.table.close());
        slices.clear();
    }

    private Slice slice(int count, long first, long pairs) {
        DeviceBuffer table =
                new DeviceBuffer(session, "table of " + config.strategy().name());
        long bytes = config.strategy().tableBytes(count, pairs);
        try {
            table.ensure(bytes);
            if (bytes > 0) {
                table.fill(bytes, memory -> config.strategy().fillTable(count, first, pairs, memory));
            }
        } catch (RuntimeException e) {
            table.close();
            throw e;
        }
        return new Slice(first, pairs, table);
    }
}
