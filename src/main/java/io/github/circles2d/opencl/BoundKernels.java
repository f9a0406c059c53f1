package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.IndexStrategies;
import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.WorldConfig;
import java.util.Arrays;
import java.util.stream.Stream;

/**
 * The kernels of one world of small steps, compiled, and bound to its heap: for each of the levels that the world has, and each of the
 * two turns.
 */
final class BoundKernels {
    private final WorldConfig config;
    private final Session session;
    private final State state;
    private final Heap heap;
    private final PairTables tables;
    /** By levels and turn; those of the first levels, and of others once they are needed. */
    private SmallKernels[] kernels;

    private Boolean wide;
    private Program program;
    private final Program solving;
    private Kernel load;
    private Kernel restore;
    /** The kernels for one work-group, once a world was so small. */
    private Program aloneProgram;

    private Levels[] levels;
    private Tiles[] tiles;
    /** The number of the levels in use. */
    private int used;

    BoundKernels(Session session, WorldConfig config, State state, Heap heap) {
        this.config = config;
        this.session = session;
        this.state = state;
        this.heap = heap;
        tables = config.strategy().pairwise() ? new PairTables(session, config) : null;
        solving = SmallKernels.solving(session, config);
        compile(false);
    }

    /** Compiles the kernels that so many circles need, unless they are so already: only pairs have numbers, of 32 or of 64 bits. */
    void compile(int circles) {
        compile(config.strategy().pairwise() && IndexStrategies.wide(circles));
    }

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

    /** Sets which levels there are. */
    void levels(Levels[] now) {
        if (!same(now)) {
            // whoever tries again after a failure writes them again
            levels = null;
            unbind();
            tiles = Stream.of(now).map(Tiles::of).toArray(Tiles[]::new);
            heap.write(now, tiles);
        }
        levels = now;
    }

    private boolean same(Levels[] others) {
        boolean same = levels != null && levels.length == others.length;
        for (int k = 0; same && k < others.length; k++) {
            same = levels[k].same(others[k]);
        }
        return same;
    }

    /** Sets which of them are in use. */
    void use(Levels now) {
        used = 0;
        while (levels[used] != now) {
            used++;
        }
    }

    /** After the heap has moved, or other tables are in it. */
    void unbind() {
        for (SmallKernels one : kernels) {
            if (one != null) {
                one.bound = false;
            }
        }
    }

    /** The kernels of a turn, with the levels in use. */
    SmallKernels of(int turn) {
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
        SmallWorld world =
                new SmallWorld(config, state, heap, turn, world(turn), levels[used], tiles[used], session.device);
        if (world.alone() && now.alone == null) {
            aloneProgram = aloneProgram == null ? SmallKernels.alone(session, config) : aloneProgram;
            now.alone = new Alone(session, aloneProgram);
        }
        now.bind(world);
        return now;
    }

    /** What every kernel of a turn begins with, with the levels in use. */
    Object[] world(int turn) {
        return heap.world(turn, used, state);
    }

    /** Takes circles from the state, of which so many have a place already; binds nothing else, which may ask for tables. */
    void load(int turn, int placed) {
        load.arguments(world(turn), state.circle, state.velocities, placed)
                .range(state.circles, session.device.group(config))
                .launch();
    }

    /** The same of circles that all have a place; allocates nothing where the kernels of the turn are bound. */
    void load(int turn) {
        int index = 2 * used + turn;
        if (index < kernels.length && kernels[index] != null && kernels[index].bound) {
            kernels[index].integrate.load();
        } else {
            load(turn, state.circles);
        }
    }

    /** Puts circles back to where they were before the detection of a turn. */
    void restore(int turn) {
        restore.arguments(world(turn))
                .range(state.circles, session.device.group(config))
                .launch();
    }
}
