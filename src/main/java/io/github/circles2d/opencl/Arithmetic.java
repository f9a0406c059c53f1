package io.github.circles2d.opencl;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.List;
import java.util.Map;

/** Host code of {@code kernels/arithmetic.cl}: whether a device computes the bits of plain Java. */
final class Arithmetic {
    private static final System.Logger LOG = System.getLogger("io.github.circles2d");
    private static final int COUNT = 4096;
    private static final int RESULTS = io.github.circles2d.host.Arithmetic.RESULTS;

    private Arithmetic() {}

    static boolean check(OpenClDevice device) {
        float[] a = io.github.circles2d.host.Arithmetic.operands(1, COUNT);
        float[] b = io.github.circles2d.host.Arithmetic.operands(2, COUNT);
        float[] expected = io.github.circles2d.host.Arithmetic.results(a, b);
        float[] got = run(device, a, b);
        int wrong = 0;
        for (int i = 0; i < expected.length; i++) {
            if (Float.floatToIntBits(got[i]) != Float.floatToIntBits(expected[i])) {
                wrong++;
            }
        }
        if (wrong > 0) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    "{0}: {1} of {2} results differ from plain Java; worlds on it are not deterministic",
                    device.name(),
                    wrong,
                    expected.length);
        }
        return wrong == 0;
    }

    private static float[] run(OpenClDevice device, float[] a, float[] b) {
        try (Session session = new Session(device)) {
            Program program =
                    Program.build(session, Map.of(), List.of(Program.file("common.cl"), Program.file("arithmetic.cl")));
            DeviceBuffer bufferA = upload(session, "a", a);
            DeviceBuffer bufferB = upload(session, "b", b);
            DeviceBuffer result = new DeviceBuffer(session, "result");
            result.ensure(4L * RESULTS * COUNT);
            new Kernel(session, program, "c2d_arithmetic")
                    .arguments(bufferA, bufferB, result, COUNT)
                    .range(COUNT, 64)
                    .launch();
            FloatBuffer copy = direct(RESULTS * COUNT);
            result.read(0, copy, 4L * RESULTS * COUNT);
            float[] results = new float[RESULTS * COUNT];
            copy.get(0, results);
            return results;
        }
    }

    private static DeviceBuffer upload(Session session, String name, float[] values) {
        DeviceBuffer buffer = new DeviceBuffer(session, name);
        buffer.ensure(4L * values.length);
        buffer.write(direct(values.length).put(0, values), 4L * values.length);
        return buffer;
    }

    private static FloatBuffer direct(int floats) {
        return ByteBuffer.allocateDirect(4 * floats)
                .order(ByteOrder.nativeOrder())
                .asFloatBuffer();
    }
}
