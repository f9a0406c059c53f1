package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** The stages of small steps for one of the two turns, bound to its parts of the heap. */
final class SmallKernels {
    final Grid grid;
    final Find find;
    final Match match;
    final Batch batch;
    final Integrate integrate;
    final Solve solve;
    /** Null until a world was so small. */
    Alone alone;

    /** Whether {@link #alone} does most of it. */
    boolean isAlone;
    /** Whether the arguments are those of the heap as it is now. */
    boolean bound;

    SmallKernels(Session session, Program program, Program solving, PairTables tables) {
        grid = new Grid(session, program);
        find = new Find(session, program, tables);
        match = new Match(session, program);
        batch = new Batch(session, program);
        integrate = new Integrate(session, program);
        solve = new Solve(session, solving);
    }

    /** Compiles the kernels for pair indices of 32 or 64 bits. */
    static Program program(Session session, WorldConfig config, boolean wide) {
        boolean pairwise = config.strategy().pairwise();
        List<Map.Entry<String, String>> sources = new ArrayList<>();
        sources.add(Program.file("common.cl"));
        if (pairwise) {
            sources.add(Map.entry(
                    "index_" + config.strategy().name() + ".cl",
                    config.strategy().kernelSource()));
        }
        for (String file : List.of(
                "numbers",
                "small",
                "scan",
                "grid",
                "find",
                pairwise ? "find_pairs" : "find_grid",
                "match",
                "batch",
                "batch_colour",
                "batch_order",
                "batch_sort",
                "batch_local",
                "batch_place",
                "walls",
                "integrate")) {
            sources.add(Program.file(file + ".cl"));
        }
        return Program.build(session, defines(session, config, wide, pairwise), sources);
    }

    /**
     * Compiles the kernels that visit contacts. A compiler that can be told how many registers a work-item may have is told: more
     * work-items at a time are worth more than what does not fit.
     */
    static Program solving(Session session, WorldConfig config) {
        String registers = session.device.limitsRegisters ? " -cl-nv-maxrregcount=" + Tuning.GPU_SOLVE_REGISTERS : "";
        return build(
                session,
                config,
                registers,
                List.of("solve"),
                "detect",
                "batch",
                "batch_colour",
                "batch_order",
                "batch_sort",
                "batch_local",
                "batch_place",
                "walls",
                "integrate",
                "visit");
    }

    /** Compiles the kernels for one work-group. */
    static Program alone(Session session, WorldConfig config) {
        return build(
                session,
                config,
                "",
                List.of("alone"),
                "detect",
                "grid",
                "batch",
                "batch_colour",
                "batch_order",
                "batch_sort",
                "batch_local",
                "batch_place",
                "walls",
                "integrate",
                "visit",
                "solve");
    }

    /** Compiles the kernels of statistics. */
    static Program stats(Session session, WorldConfig config) {
        return build(session, config, "", List.of("stats", "stats_lists"));
    }

    /** Compiles the kernels of some files, which call functions of others. */
    private static Program build(
            Session session, WorldConfig config, String options, List<String> files, String... others) {
        List<Map.Entry<String, String>> sources = new ArrayList<>();
        for (String file : List.of("common", "numbers", "small")) {
            sources.add(Program.functions(file + ".cl"));
        }
        for (String file : others) {
            sources.add(Program.functions(file + ".cl"));
        }
        for (String file : files) {
            sources.add(Program.file(file + ".cl"));
        }
        return Program.build(session, options, defines(session, config, false, false), sources);
    }

    private static Map<String, Integer> defines(Session session, WorldConfig config, boolean wide, boolean pairwise) {
        return Map.of(
                "C2D_GPU",
                session.device.asOnGpu(config) ? 1 : 0,
                "C2D_WIDE",
                wide ? 1 : 0,
                "C2D_PAIRWISE",
                pairwise ? 1 : 0,
                "C2D_ONE_GROUP",
                session.device.oneGroup(config),
                "C2D_SCAN",
                Tuning.SCAN,
                "C2D_TILE_CIRCLES",
                Tuning.TILE_CIRCLES);
    }

    void bind(SmallWorld world) {
        grid.bind(world);
        find.bind(world);
        match.bind(world);
        batch.bind(world);
        integrate.bind(world);
        solve.bind(world);
        isAlone = world.alone();
        if (isAlone) {
            alone.bind(world);
        }
        bound = true;
    }
}
