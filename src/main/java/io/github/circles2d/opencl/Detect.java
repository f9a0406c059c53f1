package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;
import java.util.ArrayList;
import java.util.List;

/**
 * Host code of {@code kernels/detect.cl}: finds the circles that overlap. Owns the thesis' triangle {@code collision}, in
 * slices.
 */
final class Detect {
    /** A part of the pairs, with the kernels that work on it. */
    private final class Slice {
        final long first;
        final long pairs;
        final DeviceBuffer table;
        final DeviceBuffer collision = new DeviceBuffer(session, "collision");
        final DeviceBuffer mark = new DeviceBuffer(session, "mark");
        Kernel detect;
        Kernel collect;

        Slice(PairTables.Slice part) {
            first = part.first();
            pairs = part.pairs();
            table = part.table();
            try {
                allocate();
            } catch (RuntimeException e) {
                // the caller may try again with fewer circles, and needs the room
                close();
                throw e;
            }
        }

        private void allocate() {
            if (triangle) {
                collision.ensure(8 * pairs);
                mark.ensure(4 * blocks(pairs));
                // zeros, as a new buffer of Java is
                mark.fill(4 * blocks(pairs), memory -> {});
                collect = new Kernel(session, program, "c2d_colour_collect");
            }
            detect = new Kernel(session, program, "c2d_detect");
        }

        void close() {
            if (collect != null) {
                collect.close();
            }
            if (detect != null) {
                detect.close();
            }
            mark.close();
            collision.close();
        }
    }

    private final Session session;
    private final Program program;
    private final PairTables tables;
    private final boolean triangle;
    private final int pairsPerItem;
    private final List<Slice> slices = new ArrayList<>();
    private int circles = -1;

    Detect(Session session, Program program, WorldConfig config, int pairsPerItem) {
        this.session = session;
        this.program = program;
        this.pairsPerItem = pairsPerItem;
        tables = new PairTables(session, config);
        triangle = config.triangle();
    }

    void bind(State state, Contacts contacts, int group) {
        if (circles != state.circles) {
            build(state.circles);
        }
        for (Slice slice : slices) {
            Object[] pairs = {slice.table, state.status, circles, slice.first, slice.pairs};
            Object[] list = {contacts.found, contacts.capacity()};
            if (triangle) {
                slice.detect.arguments(state.circle, pairs, slice.collision, slice.mark);
                slice.collect
                        .arguments(slice.collision, slice.mark, pairs, list)
                        .range(blocks(slice.pairs), group);
            } else {
                slice.detect.arguments(state.circle, pairs, list);
            }
            slice.detect.range(
                    (slice.pairs + pairsPerItem - 1) / pairsPerItem, group, Tuning.PAIRS_PER_LAUNCH / pairsPerItem);
        }
    }

    private static long blocks(long pairs) {
        return (pairs + Tuning.BLOCK - 1) / Tuning.BLOCK;
    }

    private void build(int count) {
        close();
        try {
            for (PairTables.Slice part : tables.slices(count)) {
                slices.add(new Slice(part));
            }
        } catch (RuntimeException e) {
            close();
            throw e;
        }
        circles = count;
    }

    void run() {
        for (int s = 0; s < slices.size(); s++) {
            slices.get(s).detect.launch();
        }
    }

    /** The thesis' second walk over the triangle; nothing for a compact store. */
    void collect() {
        for (int s = 0; triangle && s < slices.size(); s++) {
            slices.get(s).collect.launch();
        }
    }

    private void close() {
        circles = -1;
        slices.forEach(Slice::close);
        slices.clear();
        tables.close();
    }
}
