package io.github.circles2d.bench;

import io.github.circles2d.ComputeDevice;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * How a step grows with the number of circles: 1,000 to 10,000,000 of the scene {@code pile}, {@code grid()}, {@code SMALL_STEPS} at 8
 * substeps and at as many as the world chooses, on every device. Two states: {@code start}, the first steps of the fall, few contacts;
 * and {@code packed}, the first steps of the same circles laid on the floor and on each other ({@link Layout#packed}). That one has the
 * neighbours of a standing pile, but its solver has yet to find the forces, and 8 substeps do not hold a deep pile up for long: the
 * table says how many contacts there were and how far they overlapped. Written into a folder as {@code scaling.md}, {@code .png} and
 * {@code .csv}. A figure that takes longer than {@code --limit} seconds (60) is left out and named.
 *
 * <pre>{@code
 * mvn -q -Pbench verify -Dbench.args="Scaling"
 * mvn -q -Pbench verify -Dbench.args="Scaling --device gpu --circles 1000000 --state packed --substeps 8 --out target/scaling"
 * }</pre>
 *
 * <p>Further names: {@code --settle}, steps before those that are timed (3). Figures are added to those that are in the folder; {@code --draw} measures nothing.
 */
public final class Scaling {
    private Scaling() {}

    /** As the class comment says. */
    public static void main(String[] arguments) throws IOException {
        Args args = Args.parse(arguments, "state", "substeps", "settle").withoutJmh();
        Path folder = args.folder();
        Rows rows = new Rows(
                folder.resolve("scaling.csv"),
                4,
                "device",
                "state",
                "substeps",
                "circles",
                "ms",
                "after",
                "timed",
                "rounds",
                "ready s",
                "contacts",
                "mean overlap",
                "bytes");
        if (!args.drawOnly()) {
            rows.measure("Circles2D " + Machine.version("io.github.circles2d", "circles2d"));
            for (ComputeDevice device : Machine.devices(args)) {
                for (String state : args.list("state", "start", "packed")) {
                    for (String substeps : args.list("substeps", "8", "0")) {
                        measure(args, rows, device, state, substeps);
                    }
                }
            }
        }
        write(rows, folder);
    }

    private static void measure(Args args, Rows rows, ComputeDevice device, String state, String substeps)
            throws IOException {
        String name = Machine.label(device);
        int limit = args.limit(60);
        int settle = args.numbers("settle", "3").get(0);
        String[] sizes = {"1000", "10000", "100000", "1000000", "10000000"};
        double last = 0;
        int before = 1;
        for (int circles : args.numbers("circles", sizes)) {
            // three steps at least, and a start: no need to try what will not end
            if (last / 1000 * circles / before * 3 > limit) {
                rows.put(
                        name,
                        state,
                        substeps,
                        circles,
                        "left out: three steps are expected to take more than " + limit + " s");
                continue;
            }
            List<String> result = Child.run(
                    ScalingCase.class, 2 * limit, Machine.index(device), circles, substeps, state, settle, limit);
            rows.put(all(List.of(name, state, substeps, circles), result));
            if (result.size() == 1) {
                // larger ones would do no better
                last = Double.MAX_VALUE;
                continue;
            }
            last = Double.parseDouble(result.get(0));
            before = circles;
        }
    }

    private static Object[] all(List<Object> key, List<String> result) {
        return Stream.concat(key.stream(), result.stream()).toArray();
    }

    private static void write(Rows rows, Path folder) throws IOException {
        Markdown page = Markdown.page("A step as the number of circles grows", rows)
                .paragraph(
                        "The scene pile, grid(), SMALL_STEPS. start: the first steps of the fall. packed: the same circles laid"
                                + " on the floor and on each other: the neighbours of a standing pile, before the solver has found its"
                                + " forces. Milliseconds a step are the median of the rounds, each of so many timed steps with one"
                                + " read-back at their end; contacts and their mean overlap, a fraction of the smaller radius, are"
                                + " those of the last of them. Ready: seconds until a world of that many is built and its first step"
                                + " read back, in a JVM that ran a smaller one before.")
                .table(
                        3,
                        "device",
                        "state",
                        "substeps",
                        "circles",
                        "ms a step",
                        "ns a circle",
                        "bytes a circle",
                        "steps before",
                        "steps timed",
                        "rounds",
                        "contacts a circle",
                        "mean overlap",
                        "ready, s");
        Chart chart = new Chart("A step as the number of circles grows", "ns a circle and step");
        List<Integer> circles = rows.numbers("circles");
        List<String> kinds = List.of("start8", "packed8", "start0", "packed0");
        for (String device : rows.values("device")) {
            for (String substeps : rows.values("substeps")) {
                for (String state : rows.values("state")) {
                    circles.forEach(n -> rows.row(device, state, substeps, n).ifPresent(row -> add(page, row)));
                    chart.line(
                            device + ", " + state + ", " + auto(substeps),
                            rows.values("device").indexOf(device),
                            Math.max(0, kinds.indexOf(state + substeps)),
                            circles,
                            circles.stream()
                                    .map(n -> rows.row(device, state, substeps, n)
                                            .map(Scaling::nanoseconds)
                                            .orElse(""))
                                    .toList());
                }
            }
        }
        chart.save(folder.resolve("scaling.png"));
        page.picture("Nanoseconds a circle", "scaling.png").save(folder.resolve("scaling.md"));
    }

    private static String auto(String substeps) {
        return substeps.equals("0") ? "auto" : substeps;
    }

    private static String nanoseconds(Map<String, String> row) {
        return row.get("timed").isEmpty()
                ? ""
                : String.valueOf(Double.parseDouble(row.get("ms")) * 1e6 / Integer.parseInt(row.get("circles")));
    }

    private static void add(Markdown page, Map<String, String> row) {
        page.row(
                row.get("device"),
                row.get("state"),
                auto(row.get("substeps")),
                Markdown.count(row.get("circles")),
                Markdown.figure(row.get("ms")),
                Markdown.figure(nanoseconds(row)),
                Markdown.figure(row.get("bytes")),
                row.get("after"),
                row.get("timed"),
                row.get("rounds"),
                Markdown.figure(row.get("contacts")),
                Markdown.figure(row.get("mean overlap")),
                Markdown.figure(row.get("ready s")));
    }
}
