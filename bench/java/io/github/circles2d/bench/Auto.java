package io.github.circles2d.bench;

import io.github.circles2d.Circles2D;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import io.github.circles2d.demo.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.openjdk.jmh.util.ListStatistics;

/**
 * Whether {@link IndexStrategy#auto()} chooses well: milliseconds a step, with the read-back, of each built-in strategy and of the
 * choice, side by side: the thesis' scene under {@code IMPULSE} and {@code pile} under {@code SMALL_STEPS} at 8 substeps, on every device.
 * Worlds take turns, so that a busy machine slows all of them; the median of the rounds counts. All pairs are left out beyond 15,000
 * circles. Written into a folder as {@code auto.md} and {@code .csv}.
 *
 * <pre>{@code
 * mvn -q -Pbench verify -Dbench.args="Auto --device gpu --circles 1250,5000,15000,100000"
 * }</pre>
 *
 * <p>{@code --limit} is seconds for one number of circles (30). Figures are added to those that are in the folder.
 */
public final class Auto {
    private static final int MOST_IN_PAIRS = 15_000;
    private static final int WARM_UP = 30;
    private static final int ROUNDS = 21;
    private static final int STEPS = 3;
    /** How many times as long as the best a strategy may take to stay. */
    private static final double FAR = 3;

    private Auto() {}

    /** As the class comment says. */
    public static void main(String[] arguments) throws IOException {
        Args args = Args.parse(arguments, "solver").withoutJmh();
        Path folder = args.folder();
        Rows rows = new Rows(
                folder.resolve("auto.csv"),
                3,
                "device",
                "solver",
                "circles",
                "strategies",
                "best",
                "best ms",
                "auto ms");
        if (!args.drawOnly()) {
            rows.measure("Circles2D " + Machine.version("io.github.circles2d", "circles2d"));
            for (ComputeDevice device : Machine.devices(args)) {
                for (String solver : args.list("solver", "IMPULSE", "SMALL_STEPS")) {
                    for (int circles : args.numbers("circles", "1250", "5000", "15000")) {
                        measure(rows, device, Solver.valueOf(solver), circles, args.limit(30));
                    }
                }
            }
        }
        write(rows, folder);
    }

    private static void measure(Rows rows, ComputeDevice device, Solver solver, int circles, int limit)
            throws IOException {
        Map<IndexStrategy, Circles2D> worlds = new LinkedHashMap<>();
        Map<IndexStrategy, List<Double>> times = new LinkedHashMap<>();
        int strategies;
        try {
            List<IndexStrategy> all = new ArrayList<>(IndexStrategy.builtIn());
            all.removeIf(strategy -> strategy != IndexStrategy.grid() && circles > MOST_IN_PAIRS);
            all.add(IndexStrategy.auto());
            strategies = all.size() - 1;
            for (IndexStrategy strategy : all) {
                Circles2D.Builder builder = Circles2D.builder()
                        .device(device)
                        .solver(solver)
                        .indexStrategy(strategy)
                        .substeps(8)
                        .capacity(circles);
                worlds.put(strategy, (solver == Solver.IMPULSE ? Scene.THESIS : Scene.PILE).build(builder, circles));
                times.put(strategy, new ArrayList<>());
            }
            long end = System.nanoTime() + limit * 1_000_000_000L;
            for (int round = -WARM_UP / STEPS; round < ROUNDS && System.nanoTime() < end; round++) {
                Map<IndexStrategy, Double> took = new LinkedHashMap<>();
                worlds.forEach((strategy, world) -> took.put(strategy, milliseconds(world)));
                if (round >= 0) {
                    took.forEach((strategy, ms) -> times.get(strategy).add(ms));
                } else {
                    // of those named, what takes several times as long will not be the best: the others need the time
                    took.remove(IndexStrategy.auto());
                    double least =
                            took.values().stream().mapToDouble(ms -> ms).min().orElseThrow();
                    took.keySet().removeIf(strategy -> took.get(strategy) < FAR * least);
                    took.keySet().forEach(strategy -> worlds.remove(strategy).close());
                    times.keySet().removeAll(took.keySet());
                }
            }
        } finally {
            worlds.values().forEach(Circles2D::close);
        }
        if (times.get(IndexStrategy.auto()).isEmpty()) {
            System.err.println(Machine.label(device) + ", " + solver + ", " + circles + " circles: no round in time");
            return;
        }
        IndexStrategy best = null;
        for (IndexStrategy strategy : times.keySet()) {
            if (strategy != IndexStrategy.auto()
                    && (best == null || median(times.get(strategy)) < median(times.get(best)))) {
                best = strategy;
            }
        }
        rows.put(
                Machine.label(device),
                solver.name(),
                circles,
                strategies,
                best.name(),
                median(times.get(best)),
                median(times.get(IndexStrategy.auto())));
    }

    private static double milliseconds(Circles2D world) {
        long start = System.nanoTime();
        world.step(STEPS);
        world.snapshot();
        return (System.nanoTime() - start) / 1e6 / STEPS;
    }

    private static double median(List<Double> values) {
        return new ListStatistics(values.stream().mapToDouble(ms -> ms).toArray()).getPercentile(50);
    }

    private static void write(Rows rows, Path folder) throws IOException {
        Markdown page = Markdown.page("The strategy that a world chooses", rows)
                .paragraph(
                        "Milliseconds a step, read-back included, of the best of so many strategies named beforehand and of auto():"
                                + " the thesis' scene under IMPULSE, the pile under SMALL_STEPS at 8 substeps, from their start. Worlds take"
                                + " turns; medians of up to " + ROUNDS + " rounds of " + STEPS + " steps.")
                .table(2, "device", "solver", "circles", "strategies", "best", "best, ms", "auto(), ms", "ratio");
        for (String device : rows.values("device")) {
            for (String solver : rows.values("solver")) {
                for (int n : rows.numbers("circles")) {
                    rows.row(device, solver, n).ifPresent(row -> add(page, row));
                }
            }
        }
        page.save(folder.resolve("auto.md"));
    }

    private static void add(Markdown page, Map<String, String> row) {
        double ratio = Double.parseDouble(row.get("auto ms")) / Double.parseDouble(row.get("best ms"));
        page.row(
                row.get("device"),
                row.get("solver"),
                Markdown.count(row.get("circles")),
                row.get("strategies"),
                row.get("best"),
                Markdown.figure(row.get("best ms")),
                Markdown.figure(row.get("auto ms")),
                Markdown.figure(Double.toString(ratio)));
    }
}
