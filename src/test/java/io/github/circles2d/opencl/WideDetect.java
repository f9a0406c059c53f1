package io.github.circles2d.opencl;

import io.github.circles2d.CollisionStore;
import io.github.circles2d.IndexStrategy;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/** Launches detect with pair indices of 64 bits on a few circles; a world does so only from 65,537 circles on. */
final class WideDetect {
    private WideDetect() {}

    /** A row of circles, each touching its neighbours. */
    private static FloatBuffer row(int circles) {
        FloatBuffer row = bytes(16L * circles).asFloatBuffer();
        for (int i = 0; i < circles; i++) {
            row.put(4 * i, 0.1f * i).put(4 * i + 2, 0.06f).put(4 * i + 3, 1);
        }
        return row;
    }

    /** The pairs that touch, packed. */
    static Set<Long> expected(int circles) {
        Set<Long> pairs = new TreeSet<>();
        for (int i = 0; i + 1 < circles; i++) {
            pairs.add(IndexStrategy.pack(i, i + 1));
        }
        return pairs;
    }

    /** The pairs that the device finds, packed. */
    static Set<Long> contacts(OpenClDevice device, IndexStrategy strategy, CollisionStore store, int circles) {
        boolean triangle = store == CollisionStore.TRIANGLE;
        long pairs = IndexStrategy.pairs(circles);
        try (Session session = new Session(device)) {
            Program program = Program.build(
                    session,
                    Map.of("C2D_WIDE", 1, "C2D_TRIANGLE", triangle ? 1 : 0),
                    List.of(
                            Program.file("common.cl"),
                            Map.entry("index.cl", strategy.kernelSource()),
                            Program.file("detect.cl"),
                            Program.file("contact.cl"),
                            Program.file("colour.cl")));
            DeviceBuffer circle = upload(session, "circle", row(circles), 16L * circles);
            DeviceBuffer status = upload(session, "status", bytes(12).asIntBuffer(), 12);
            ByteBuffer table = table(strategy, circles, pairs);
            DeviceBuffer tableBuffer = upload(session, "table", table, table.capacity());
            DeviceBuffer found = room(session, "found", Contacts.BYTES * circles);
            Object[] slice = {tableBuffer, status, circles, 0L, pairs};
            Object[] list = {found, circles};
            if (triangle) {
                DeviceBuffer collision = room(session, "collision", 8 * pairs);
                // all zero, which is the number of a step without an update: every block is marked
                DeviceBuffer mark = upload(session, "mark", bytes(4 * pairs).asIntBuffer(), 4 * pairs);
                new Kernel(session, program, "c2d_detect")
                        .arguments(circle, slice, collision, mark)
                        .range(pairs, 32)
                        .launch();
                new Kernel(session, program, "c2d_colour_collect")
                        .arguments(collision, mark, slice, list)
                        .range(pairs, 32)
                        .launch();
            } else {
                new Kernel(session, program, "c2d_detect")
                        .arguments(circle, slice, list)
                        .range(pairs, 32)
                        .launch();
            }
            IntBuffer count = bytes(4).asIntBuffer();
            status.read(0, count, 4);
            int contacts = Math.min(count.get(0), circles);
            IntBuffer copy = bytes(Contacts.BYTES * circles).asIntBuffer();
            found.read(0, copy, Contacts.BYTES * contacts);
            Set<Long> result = new TreeSet<>();
            for (int k = 0; k < contacts; k++) {
                result.add(IndexStrategy.pack(copy.get(4 * k), copy.get(4 * k + 1)));
            }
            return result;
        }
    }

    private static ByteBuffer table(IndexStrategy strategy, int circles, long pairs) {
        if (strategy == IndexStrategy.rowSearch()) {
            // so few circles give it a table of 32 bits
            ByteBuffer rows = bytes(16L * (circles - 1));
            long start = 0;
            for (int row = 0; row < circles - 1; row++) {
                long end = start + circles - 2 - row;
                rows.putLong(16 * row, start).putLong(16 * row + 8, end);
                start = end + 1;
            }
            return rows;
        }
        ByteBuffer table = bytes(strategy.tableBytes(circles, pairs));
        strategy.fillTable(circles, 0, pairs, table);
        return table;
    }

    private static DeviceBuffer room(Session session, String name, long bytes) {
        DeviceBuffer buffer = new DeviceBuffer(session, name);
        buffer.ensure(bytes);
        return buffer;
    }

    private static DeviceBuffer upload(Session session, String name, java.nio.Buffer from, long bytes) {
        DeviceBuffer buffer = room(session, name, bytes);
        buffer.write(from, bytes);
        return buffer;
    }

    private static ByteBuffer bytes(long count) {
        return ByteBuffer.allocateDirect(Math.toIntExact(count)).order(ByteOrder.nativeOrder());
    }
}
