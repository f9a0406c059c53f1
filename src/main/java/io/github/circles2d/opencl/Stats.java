package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.StepSums;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.Supplier;

/** Host code of {@code kernels/stats.cl}: what a step looks like. Binds its kernels each time: it is not for every step. */
final class Stats {
    private final Session session;
    private final WorldConfig config;
    private final int group;
    private final Supplier<Program> compiler;
    private Program program;
    private Kernel circles;
    private Kernel contacts;
    private DeviceBuffer parts;
    private ByteBuffer copy = ByteBuffer.allocateDirect(0);

    /** @param compiler compiles the kernels, when they are needed first */
    Stats(Session session, WorldConfig config, int group, Supplier<Program> compiler) {
        this.session = session;
        this.config = config;
        this.group = group;
        this.compiler = compiler;
    }

    /** Of {@code Solver.IMPULSE}. */
    StepSums ofFound(State state, DeviceBuffer found, int count) {
        StepSums sums = ofCircles(state);
        ofContacts(sums, "c2d_stats_found", count, state.circle, found, count);
        return sums;
    }

    /** Of {@code Solver.SMALL_STEPS}. */
    StepSums ofLists(State state, Object[] world) {
        StepSums sums = ofCircles(state);
        ofContacts(sums, "c2d_stats_lists", state.circles, world);
        return sums;
    }

    private StepSums ofCircles(State state) {
        if (circles == null) {
            program = compiler.get();
            parts = new DeviceBuffer(session, "parts");
            circles = new Kernel(session, program, "c2d_stats_circles");
        }
        StepSums sums = new StepSums();
        int count = StepSums.parts(state.circles);
        parts.ensure((long) StepSums.CIRCLES_BYTES * count);
        float[] bounds = {config.minX(), config.minY(), config.maxX(), config.maxY()};
        circles.arguments(state.circle, state.velocities, state.circles, bounds, config.inside(), parts)
                .range(count, group)
                .launch();
        sums.addCircles(read(StepSums.CIRCLES_BYTES * count), count);
        return sums;
    }

    private void ofContacts(StepSums sums, String kernel, int items, Object... arguments) {
        if (contacts == null) {
            contacts = new Kernel(session, program, kernel);
        }
        int count = StepSums.parts(items);
        parts.ensure((long) StepSums.CONTACTS_BYTES * count);
        contacts.arguments(arguments, parts).range(count, group).launch();
        sums.addContacts(read(StepSums.CONTACTS_BYTES * count), count);
    }

    private ByteBuffer read(int bytes) {
        if (copy.capacity() < bytes) {
            copy = ByteBuffer.allocateDirect(bytes).order(ByteOrder.nativeOrder());
        }
        parts.read(0, copy.clear(), bytes);
        return copy;
    }
}
