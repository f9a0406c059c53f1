package io.github.circles2d.opencl;

import io.github.circles2d.IndexStrategy;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import java.util.List;
import java.util.Map;

/** Asks a strategy's kernel source for the pairs of given numbers; one program serves any number of circles. */
final class PairKernel implements AutoCloseable {
    private static final String SOURCE = """
            __kernel void c2d_test_pairs(__global const int2 *table, __global const ulong *numbers, ulong first,
                                         int circles, int count, __global int2 *result) {
                const int item = (int)get_global_id(0);
                if (item < count) {
                    result[item] = c2d_pair_at((c2d_index)numbers[item], (c2d_index)first, circles, table);
                }
            }
            """;

    private final Session session;
    private final Kernel kernel;
    private final DeviceBuffer table;
    private final DeviceBuffer numbers;
    private final DeviceBuffer result;
    private final IndexStrategy strategy;

    PairKernel(OpenClDevice device, IndexStrategy strategy, boolean wide) {
        this.strategy = strategy;
        session = new Session(device);
        Program program = Program.build(
                session,
                Map.of("C2D_WIDE", wide ? 1 : 0),
                List.of(
                        Program.file("common.cl"),
                        Map.entry("index.cl", strategy.kernelSource()),
                        Map.entry("test.cl", SOURCE)));
        kernel = new Kernel(session, program, "c2d_test_pairs");
        table = new DeviceBuffer(session, "table");
        numbers = new DeviceBuffer(session, "numbers");
        result = new DeviceBuffer(session, "result");
        table.ensure(0);
    }

    /** Fills the look-up table for a range of the pairs. */
    void table(int circles, long first, long pairs) {
        long bytes = strategy.tableBytes(circles, pairs);
        table.ensure(bytes);
        if (bytes > 0) {
            table.fill(bytes, memory -> strategy.fillTable(circles, first, pairs, memory));
        }
    }

    /** What later calls of {@link #pairs} ask for. */
    void numbers(long[] which) {
        ByteBuffer copy = ByteBuffer.allocateDirect(8 * which.length).order(ByteOrder.nativeOrder());
        copy.asLongBuffer().put(which);
        numbers.ensure(8L * which.length);
        numbers.write(copy, 8L * which.length);
        result.ensure(8L * which.length);
    }

    /** The pairs of the first {@code count} numbers: i, j, i, j, ... */
    IntBuffer pairs(int circles, long first, int count) {
        kernel.arguments(table, numbers, first, circles, count, result).range(count, 64);
        kernel.launch();
        IntBuffer pairs = ByteBuffer.allocateDirect(8 * count)
                .order(ByteOrder.nativeOrder())
                .asIntBuffer();
        result.read(0, pairs, 8L * count);
        return pairs;
    }

    @Override
    public void close() {
        session.close();
    }
}
