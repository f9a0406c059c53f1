package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Changes;
import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Motion;
import io.github.circles2d.pipeline.Population;
import io.github.circles2d.pipeline.SmallStages;
import io.github.circles2d.pipeline.Status;
import io.github.circles2d.pipeline.StepSums;
import io.github.circles2d.pipeline.Substeps;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.FloatBuffer;

/** The stages of one world of small steps on an OpenCL device. Calls queue up, in order. */
final class OpenClSmallStages implements SmallStages {
    private final WorldConfig config;
    private final Session session;
    private final State state;
    private final Heap heap;
    private final BoundKernels kernels;
    private final Stats stats;
    private Substeps substeps;
    /** Whether there is a detection in the step. */
    private boolean lists;

    /** Detections queued, and those known to be done. */
    private long queued;

    private long done;
    /** Substeps asked for last. */
    private int waiting;
    /** Circles that have a place. */
    private int placed;

    private boolean closed;

    OpenClSmallStages(OpenClDevice device, WorldConfig config) {
        this.config = config;
        session = new Session(device);
        try {
            state = new State(session);
            heap = new Heap(session);
            stats = new Stats(session, config, device.group(config), () -> SmallKernels.stats(session, config));
            kernels = new BoundKernels(session, config, state, heap);
        } catch (RuntimeException e) {
            session.close();
            throw e;
        }
    }

    @Override
    public void upload(Population population, FloatBuffer velocities, Levels[] newLevels, Levels newUsed) {
        kernels.compile(newUsed.circles);
        state.upload(population, velocities);
        if (heap.ensureCircles(newLevels, population.transforms().capacity() / 4)) {
            kernels.unbind();
        }
        kernels.levels(newLevels);
        kernels.use(newUsed);
        kernels.load(lastTurn(), placed);
        placed = newUsed.circles;
    }

    @Override
    public void velocities(FloatBuffer velocities, Changes changed) {
        state.velocities(velocities, changed);
        kernels.load(lastTurn());
    }

    @Override
    public void use(Levels now) {
        kernels.use(now);
    }

    /** Of the last detection. */
    private int lastTurn() {
        return (int) (queued + 1 & 1);
    }

    /** The kernels of the last detection. */
    private SmallKernels now() {
        return kernels.of(lastTurn());
    }

    @Override
    public void download(FloatBuffer transforms, FloatBuffer velocities) {
        state.download(transforms, velocities);
    }

    @Override
    public void begin(Substeps now, float ratio, boolean hasDetection) {
        lists = hasDetection;
        if (now == substeps && ratio == 1) {
            return;
        }
        substeps = now;
        heap.setNumbers(now, ratio);
        if (ratio != 1) {
            now().solve.rescale();
        }
    }

    @Override
    public void detect(float horizon, float slack) {
        SmallKernels now = kernels.of((int) (queued & 1));
        if (now.isAlone) {
            now.alone.grid();
            now.find.run(horizon, slack);
            now.match.run();
            now.alone.batch();
        } else {
            now.grid.run();
            now.find.run(horizon, slack);
            now.match.run();
            now.batch.run(groups());
        }
        queued++;
    }

    @Override
    public void integrate() {
        SmallKernels now = now();
        if (now.isAlone) {
            now.alone.solve(waiting);
        } else {
            now.integrate.run();
        }
    }

    @Override
    public void solve(int count) {
        // one work-group does the end of the last as well
        waiting = count;
        SmallKernels now = now();
        if (!now.isAlone) {
            now.solve.run(count, groups(), lists);
        }
    }

    /**
     * Groups of a launch for the tiles of a tiling that have anything in them: their number is not known yet, but seldom far from that of
     * the step before.
     */
    private int groups() {
        int before = state.tiles();
        return before == 0 || !session.device.asOnGpu(config)
                ? Integer.MAX_VALUE
                : before + before / 8 + Tuning.MORE_TILES;
    }

    @Override
    public void publish() {
        state.changes();
        SmallKernels now = now();
        if (now.isAlone) {
            now.alone.solveLast(waiting, lists);
        } else {
            now.integrate.publish();
        }
        session.flush();
    }

    @Override
    public Motion motion() {
        return state.motion();
    }

    @Override
    public Status await(boolean reading) {
        Status status = state.await(reading);
        done += status.updates();
        return status;
    }

    @Override
    public void makeRoom(long needed) {
        kernels.restore((int) (done & 1));
        heap.ensureContacts(Math.max(needed, (long) Math.min(Heap.MOST_CONTACTS, needed * Tuning.GROWTH)));
        state.clearStatus();
        kernels.unbind();
        queued = done;
    }

    @Override
    public StepSums sums() {
        return stats.ofLists(state, kernels.world(lastTurn()));
    }

    @Override
    public long bytes() {
        return session.bytes();
    }

    @Override
    public void close() {
        if (!closed) {
            closed = true;
            try {
                assert heap.intact() : "a kernel wrote beyond its part of the heap";
            } finally {
                session.close();
            }
        }
    }
}
