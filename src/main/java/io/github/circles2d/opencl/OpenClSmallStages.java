package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.IndexStrategies;
import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Motion;
import io.github.circles2d.pipeline.SmallStages;
import io.github.circles2d.pipeline.Status;
import io.github.circles2d.pipeline.StepSums;
import io.github.circles2d.pipeline.Substeps;
import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.FloatBuffer;
import java.util.Arrays;
import java.util.stream.Stream;

/** The stages of one world of small steps on an OpenCL device. Calls queue up, in order. */
final class OpenClSmallStages implements SmallStages {
    private final WorldConfig config;
    private final Session session;
    private final State state;
    private final Heap heap;
    private final PairTables tables;
    /** By levels and turn; those of the first levels, and of others once they are needed. */
    private SmallKernels[] kernels;

    private final int group;
    private Boolean wide;
    private Program program;
    private final Program solving;
    private Kernel load;
    private Kernel restore;
    /** The kernels for one work-group, once a world was so small. */
    private Program aloneProgram;

    private final Stats stats;
    private Levels[] levels;
    private Tiles[] tiles;
    /** The number of the levels in use. */
    private int used;

    private Substeps substeps;
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
        group = device.group(config);
        session = new Session(device);
        try {
            state = new State(session);
            heap = new Heap(session);
            tables = config.strategy().pairwise() ? new PairTables(session, config) : null;
            stats = new Stats(session, config, group, () -> SmallKernels.stats(session, config));
            solving = SmallKernels.solving(session, config);
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
        kernels = new SmallKernels[] {
            new SmallKernels(session, program, solving, tables), new SmallKernels(session, program, solving, tables)
        };
        load = new Kernel(session, program, "c2d_load");
        restore = new Kernel(session, program, "c2d_find_restore");
        wide = wanted;
        if (old != null) {
            old.close();
        }
    }

    @Override
    public void upload(FloatBuffer circle, FloatBuffer velocities, Levels[] newLevels, Levels newUsed) {
        int circles = newUsed.circles;
        // only pairs have numbers
        compile(config.strategy().pairwise() && IndexStrategies.wide(circles));
        state.upload(circle, velocities, circles);
        if (heap.ensureCircles(newLevels, circle.capacity() / 4)) {
            unbind();
        }
        if (!same(newLevels)) {
            // whoever tries again after a failure writes them again
            levels = null;
            unbind();
            tiles = Stream.of(newLevels).map(Tiles::of).toArray(Tiles[]::new);
            heap.write(newLevels, tiles);
        }
        levels = newLevels;
        use(newUsed);
        load.arguments(last(), state.circle, state.velocities, placed)
                .range(circles, group)
                .launch();
        placed = circles;
    }

    private boolean same(Levels[] others) {
        boolean same = levels != null && levels.length == others.length;
        for (int k = 0; same && k < others.length; k++) {
            same = levels[k].same(others[k]);
        }
        return same;
    }

    @Override
    public void use(Levels now) {
        used = 0;
        while (levels[used] != now) {
            used++;
        }
    }

    private void unbind() {
        for (SmallKernels one : kernels) {
            if (one != null) {
                one.bound = false;
            }
        }
    }

    /** Of the last detection. */
    private int lastTurn() {
        return (int) (queued + 1 & 1);
    }

    /** The kernels of the last detection. */
    private SmallKernels now() {
        return bound(lastTurn());
    }

    /** What kernels begin with that work on what the last detection has left. */
    private Object[] last() {
        return heap.world(lastTurn(), used, state);
    }

    @Override
    public void download(FloatBuffer circle, FloatBuffer velocities) {
        state.download(circle, velocities);
    }

    @Override
    public void begin(Substeps now, float ratio) {
        if (now == substeps && ratio == 1) {
            return;
        }
        substeps = now;
        heap.numbers(now, ratio);
        if (ratio != 1) {
            bound(lastTurn()).solve.rescale();
        }
    }

    @Override
    public void detect(float horizon, float slack) {
        SmallKernels now = bound((int) (queued & 1));
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

    /** The kernels of a turn. */
    private SmallKernels bound(int turn) {
        int index = 2 * used + turn;
        if (index >= kernels.length) {
            kernels = Arrays.copyOf(kernels, index + 1);
        }
        if (kernels[index] == null) {
            kernels[index] = new SmallKernels(session, program, solving, tables);
        }
        SmallKernels now = kernels[index];
        if (now.bound) {
            return now;
        }
        SmallWorld world = new SmallWorld(
                config, state, heap, turn, heap.world(turn, used, state), levels[used], tiles[used], session.device);
        if (world.alone() && now.alone == null) {
            aloneProgram = aloneProgram == null ? SmallKernels.alone(session, config) : aloneProgram;
            now.alone = new Alone(session, aloneProgram);
        }
        now.bind(world);
        return now;
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
            now.solve.run(count, groups());
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
            now.alone.solveLast(waiting);
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
        restore.arguments(heap.world((int) (done & 1), used, state))
                .range(state.circles, group)
                .launch();
        heap.ensureContacts(Math.max(needed, (long) Math.min(Heap.MOST_CONTACTS, needed * Tuning.GROWTH)));
        state.clearStatus();
        unbind();
        queued = done;
    }

    @Override
    public StepSums sums() {
        return stats.ofLists(state, last());
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
