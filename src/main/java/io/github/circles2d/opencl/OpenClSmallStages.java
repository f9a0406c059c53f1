package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.IndexStrategies;
import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.SmallStages;
import io.github.circles2d.pipeline.Status;
import io.github.circles2d.pipeline.Substeps;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;

/** The stages of one world of small steps on an OpenCL device. Calls queue up, in order. */
final class OpenClSmallStages implements SmallStages {
    private final WorldConfig config;
    private final Session session;
    private final State state;
    private final SmallBuffers buffers;
    private final PairTables tables;
    private final SmallKernels[] kernels = new SmallKernels[2];
    private final FloatBuffer numbers;
    private final int group;
    private final int oneGroup;
    private IntBuffer pairs = IntBuffer.allocate(0);
    private Boolean wide;
    private Program program;
    private Kernel load;
    private Kernel rescale;
    private Levels levels;
    private Substeps substeps;
    /** Detections queued, and those known to be done. */
    private long queued;

    private long done;
    private boolean closed;

    OpenClSmallStages(OpenClDevice device, WorldConfig config) {
        this.config = config;
        group = device.group(config);
        oneGroup = device.oneGroup(config);
        numbers = ByteBuffer.allocateDirect(4 * Substeps.NUMBERS)
                .order(ByteOrder.nativeOrder())
                .asFloatBuffer();
        session = new Session(device);
        try {
            state = new State(session);
            buffers = new SmallBuffers(session);
            buffers.rule.ensure(4L * Substeps.NUMBERS);
            tables = config.strategy().pairwise() ? new PairTables(session, config) : null;
            compile(false);
        } catch (RuntimeException e) {
            session.close();
            throw e;
        }
    }

    /** Compiles the kernels for pair indices of 32 or 64 bits, unless they are so already. */
    private void compile(boolean wanted) {
        if (wide != null && wide == wanted) {
            return;
        }
        Program old = program;
        program = SmallKernels.program(session, config, wanted);
        // kernels of the old program go with the session; a world crosses this line once
        for (int k = 0; k < kernels.length; k++) {
            kernels[k] = new SmallKernels(session, program, tables);
        }
        load = new Kernel(session, program, "c2d_load");
        rescale = new Kernel(session, program, "c2d_rescale");
        wide = wanted;
        if (old != null) {
            old.close();
        }
    }

    @Override
    public void upload(FloatBuffer circle, FloatBuffer velocities, Levels newLevels) {
        int circles = newLevels.circles;
        compile(IndexStrategies.wide(circles));
        state.upload(circle, velocities, circles);
        if (levels == null || !levels.same(newLevels)) {
            buffers.ensureCircles(newLevels, circle.capacity() / 4);
            buffers.ensureContacts((long) Tuning.CONTACTS_PER_CIRCLE * circles + Tuning.FIRST_CONTACTS);
            buffers.levelOf.fill(4L * Math.max(1, circles), memory -> {
                for (int i = 0; i < circles; i++) {
                    memory.putInt(newLevels.levelOf(circle.get(4 * i + 2)));
                }
            });
            levels = newLevels;
            unbind();
        }
        Turn last = last();
        load.arguments(state.circle, state.velocities, buffers.kick, circles, last.body, last.id)
                .range(circles, group)
                .launch();
    }

    private void unbind() {
        for (SmallKernels one : kernels) {
            one.bound = false;
        }
    }

    /** Of the last detection. */
    private int lastIndex() {
        return (int) (queued + 1 & 1);
    }

    private Turn last() {
        return buffers.turns[lastIndex()];
    }

    @Override
    public void download(FloatBuffer circle, FloatBuffer velocities) {
        state.download(circle, velocities);
    }

    @Override
    public void begin(Substeps now) {
        if (now == substeps) {
            return;
        }
        substeps = now;
        buffers.rule.write(numbers.put(0, now.numbers()), 4L * Substeps.NUMBERS);
        if (now.rescales()) {
            Turn last = last();
            rescale.arguments(
                            last.body,
                            buffers.walls,
                            last.memory,
                            last.ownerStart,
                            last.cells,
                            state.circles,
                            buffers.rule)
                    .range(Math.max(1, state.circles), group)
                    .launch();
        }
    }

    @Override
    public void detect(float horizon, float fall) {
        int index = (int) (queued & 1);
        SmallKernels now = kernels[index];
        if (!now.bound) {
            bind(index);
        }
        now.grid.run();
        now.find.run(horizon, fall);
        now.match.run();
        queued++;
    }

    private void bind(int index) {
        Turn now = buffers.turns[index];
        Turn before = buffers.turns[1 - index];
        if (now.ready(levels)) {
            // the other turn reads what this one writes, and some of that is now elsewhere
            kernels[1 - index].bound = false;
        }
        kernels[index].bind(config, state, buffers, now, before, levels, group, oneGroup);
    }

    @Override
    public void integrate(boolean move, boolean kick) {
        kernels[lastIndex()].integrate.run(move, kick);
    }

    @Override
    public void solve() {
        kernels[lastIndex()].solve.run();
    }

    @Override
    public void publish() {
        state.changes();
        kernels[lastIndex()].integrate.publish();
        session.flush();
    }

    @Override
    public float fastest() {
        return state.fastest();
    }

    @Override
    public Status await() {
        Status status = state.await();
        done += status.updates();
        return status;
    }

    @Override
    public void makeRoom(long needed) {
        buffers.ensureContacts((long) Math.min(Integer.MAX_VALUE, Math.max(needed, needed * Tuning.GROWTH)));
        state.clearStatus();
        unbind();
        queued = done;
    }

    @Override
    public void contacts(int from, int count, IntBuffer to) {
        if (pairs.capacity() < 2 * count) {
            pairs = ByteBuffer.allocateDirect(8 * count)
                    .order(ByteOrder.nativeOrder())
                    .asIntBuffer();
        }
        last().ids.read(8L * from, pairs, 8L * count);
        for (int k = 0; k < count; k++) {
            to.put(4 * k, pairs.get(2 * k)).put(4 * k + 1, pairs.get(2 * k + 1));
        }
    }

    @Override
    public void close() {
        if (!closed) {
            closed = true;
            session.close();
        }
    }
}
