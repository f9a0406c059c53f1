package io.github.circles2d.opencl;

import io.github.circles2d.OpenClException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;

/** Faults that the Oclgrind gate must report: a gate that never fails is no gate. */
enum PlantedFault {
    RACE("values[0] += get_global_id(0);"),
    BOUNDS("values[get_global_id(0)] = values[get_global_id(0) + 64];"),
    /** Found only where the compiler does not optimise. */
    UNINITIALISED("int never; if (values[0] == 7) { never = 1; } if (never == 3) { values[get_global_id(0)] = 1; }"),
    DIVERGENCE("if (get_local_id(0) == 0) { barrier(CLK_GLOBAL_MEM_FENCE); } values[get_global_id(0)] = 1;"),
    /** A launch without its argument. */
    CALL("values[get_global_id(0)] = 1;");

    private static final int ITEMS = 32;

    private final String body;

    PlantedFault(String body) {
        this.body = body;
    }

    void run(OpenClDevice device) {
        String source = "__kernel void c2d_planted(__global int *values) {\n" + body + "\n}\n";
        try (Session session = new Session(device)) {
            Program program = Program.build(session, Map.of(), List.of(Map.entry("planted.cl", source)));
            DeviceBuffer values = new DeviceBuffer(session, "values");
            values.ensure(4 * ITEMS);
            values.write(ByteBuffer.allocateDirect(4 * ITEMS), 4 * ITEMS);
            Kernel kernel = new Kernel(session, program, "c2d_planted");
            if (this != CALL) {
                kernel.arguments(values);
            }
            kernel.range(ITEMS, ITEMS).launch();
            session.flush();
            values.read(0, ByteBuffer.allocateDirect(4), 4);
        } catch (OpenClException e) {
            if (this != CALL) {
                throw e;
            }
        }
    }
}
