package io.github.circles2d.opencl;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.TestDevices;
import io.github.circles2d.pipeline.SmallSteps;
import java.nio.FloatBuffer;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** The kernel of the self-check and its twin. */
class ArithmeticTest {
    private static final int RESULTS = io.github.circles2d.host.Arithmetic.RESULTS;

    private final OpenClDevice device = (OpenClDevice) TestDevices.openClInside();

    @Test
    void kernelGivesTheBitsOfItsTwin() {
        try (Session session = new Session(device)) {
            Program program =
                    Program.build(session, Map.of(), List.of(Program.file("common.cl"), Program.file("arithmetic.cl")));
            Kernel kernel = new Kernel(session, program, "c2d_arithmetic");
            DeviceBuffer a = new DeviceBuffer(session, "a");
            DeviceBuffer b = new DeviceBuffer(session, "b");
            DeviceBuffer result = new DeviceBuffer(session, "result");
            for (int count : new int[] {1, 2, 63, 64, 65, 1000}) {
                for (long seed = 10; seed < 40; seed++) {
                    float[] x = io.github.circles2d.host.Arithmetic.operands(seed, count);
                    float[] y = io.github.circles2d.host.Arithmetic.operands(-seed, count);
                    write(a, x);
                    write(b, y);
                    result.ensure(4L * RESULTS * count);
                    kernel.arguments(a, b, result, count).range(count, 64).launch();
                    FloatBuffer got = SmallSteps.direct(RESULTS * count);
                    result.read(0, got, 4L * RESULTS * count);
                    float[] results = new float[RESULTS * count];
                    got.get(0, results);
                    assertArrayEquals(
                            bits(io.github.circles2d.host.Arithmetic.results(x, y)),
                            bits(results),
                            "seed " + seed + ", " + count);
                }
            }
        }
    }

    @Test
    void aDeviceThatGivesJavasBitsSaysSo() {
        assertTrue(device.deterministic());
    }

    private static void write(DeviceBuffer to, float[] values) {
        to.ensure(4L * values.length);
        to.write(SmallSteps.direct(values.length).put(0, values), 4L * values.length);
    }

    /** NaN is NaN, whatever its bits. */
    private static int[] bits(float[] values) {
        int[] bits = new int[values.length];
        for (int i = 0; i < values.length; i++) {
            bits[i] = Float.floatToIntBits(values[i]);
        }
        return bits;
    }
}
