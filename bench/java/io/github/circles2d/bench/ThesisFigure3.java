package io.github.circles2d.bench;

import io.github.circles2d.ComputeDevice;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.openjdk.jmh.runner.options.CommandLineOptionException;

/**
 * Figure 3 of the thesis anew: {@link ThesisStep} for every device of the machine, each strategy and store, printed as the thesis
 * prints it, and written with a chart into a folder, {@code thesis-figure3.md}, {@code .png} and {@code .csv}. Circles go from 1,250 up
 * as long as {@code --limit} seconds (60) suffice for {@value ThesisStep#STEPS} steps; where they do not the table says so.
 *
 * <pre>{@code
 * mvn -q -Pbench verify -Dbench.args="ThesisFigure3"
 * mvn -q -Pbench verify -Dbench.args="ThesisFigure3 --device gpu,cpu --circles 1250,15000 --store COMPACT --out target/figure3"
 * mvn -q -Pbench verify -Dbench.args="ThesisFigure3 --draw --out bench/results/h100"
 * }</pre>
 *
 * <p>Further names: {@code --strategy}, {@code --from} (0; 900 is a heap). What else there is goes to JMH, {@code -f 3} say. Figures are
 * added to those that are in the folder; {@code --draw} measures nothing.
 */
public final class ThesisFigure3 {
    private ThesisFigure3() {}

    /** As the class comment says. */
    public static void main(String[] arguments) throws IOException, CommandLineOptionException {
        Args args = Args.parse(arguments, "strategy", "store", "from");
        Path folder = args.folder();
        Rows rows = new Rows(
                folder.resolve("thesis-figure3.csv"),
                5,
                "device",
                "store",
                "from",
                "strategy",
                "circles",
                "ms",
                "error",
                "iterations");
        if (!args.drawOnly()) {
            rows.measure("Circles2D " + Machine.version("io.github.circles2d", "circles2d") + ", JMH "
                    + Machine.version("org.openjdk.jmh", "jmh-core"));
            new ThesisFigure3().measure(args, rows);
        }
        Figure3Page.write(rows, folder);
    }

    /** Milliseconds a step, and how many circles, of the last size of a device, strategy and store. */
    private record Last(double ms, int circles) {}

    private final Map<List<String>, Last> last = new HashMap<>();
    private final Set<List<String>> failed = new HashSet<>();

    // sizes outermost: a run that is cut short has whole rows of the table
    private void measure(Args args, Rows rows) throws IOException, CommandLineOptionException {
        String[] sizes = {"1250", "2500", "5000", "10000", "15000", "25000", "50000", "100000"};
        for (String from : args.list("from", "0")) {
            for (int circles : args.numbers("circles", sizes)) {
                for (String store : args.list("store", "COMPACT", "TRIANGLE")) {
                    for (ComputeDevice device : Machine.devices(args)) {
                        for (String strategy : args.list("strategy", "formula", "pair_table", "row_search", "folded")) {
                            cell(args, rows, device, store, from, strategy, circles);
                        }
                    }
                }
            }
        }
    }

    private void cell(
            Args args, Rows rows, ComputeDevice device, String store, String from, String strategy, int circles)
            throws IOException, CommandLineOptionException {
        int limit = args.limit(60);
        String name = Machine.label(device);
        List<String> combination = List.of(name, store, from, strategy);
        if (failed.contains(combination)) {
            rows.put(name, store, from, strategy, circles, "not tried: fewer circles failed");
            return;
        }
        Last before = last.get(combination);
        // pairs grow with the square
        double expected = before == null
                ? 0
                : before.ms / 1000 * ThesisStep.STEPS * Math.pow((double) circles / before.circles, 2);
        if (expected > limit) {
            rows.put(
                    name,
                    store,
                    from,
                    strategy,
                    circles,
                    "left out: 100 steps are expected to take more than " + limit + " s");
            return;
        }
        Map<String, String> parameters = new LinkedHashMap<>();
        parameters.put("device", Machine.index(device));
        parameters.put("strategy", strategy);
        parameters.put("store", store);
        parameters.put("from", from);
        parameters.put("circles", String.valueOf(circles));
        JmhCell cell = JmhCell.run(ThesisStep.class, args, parameters, expected, limit, null);
        if (cell.failure() != null) {
            failed.add(combination);
            rows.put(name, store, from, strategy, circles, cell.failure());
            return;
        }
        last.put(combination, new Last(cell.score(), circles));
        rows.put(
                name,
                store,
                from,
                strategy,
                circles,
                cell.score(),
                cell.error(),
                cell.result().getPrimaryResult().getSampleCount());
    }
}
