package io.github.circles2d.bench;

import io.github.circles2d.ComputeDevice;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.openjdk.jmh.runner.options.CommandLineOptionException;

/**
 * What a game pays for each frame: {@link FrameStep} with 1,000 to 1,000,000 circles on every device, the time in {@code step()} and in
 * {@code snapshot()} where 0, 1, 4 and 10 ms of other work lie between them, and the bytes that a frame takes from the heap. Written
 * into a folder as {@code frame.md}, {@code .png} and {@code .csv}. Sizes that {@code --limit} seconds (60) do not suffice for are left
 * out and named.
 *
 * <pre>{@code
 * mvn -q -Pbench verify -Dbench.args="Frame"
 * mvn -q -Pbench verify -Dbench.args="Frame --device gpu --circles 1000,100000 --work 0,4 --out target/frame"
 * }</pre>
 *
 * <p>Further names: {@code --substeps} (8), {@code --kicks} (0: circles whose velocity is set before each step), {@code --background}
 * (false,true: whether the world makes its steps on a thread of its own). What else there is goes to JMH. Figures are added to those
 * that are in the folder; {@code --draw} measures nothing.
 */
public final class Frame {
    private Frame() {}

    /** What is measured with each number of circles. */
    private record Way(String device, String substeps, String background, String kicks, String work) {
        Object[] row(int circles, Object... figures) {
            return Stream.concat(Stream.of(device, substeps, background, kicks, work, circles), Stream.of(figures))
                    .toArray();
        }

        Optional<Map<String, String>> in(Rows rows, int circles) {
            return rows.row(row(circles));
        }

        String label(Rows rows) {
            return device + ", work " + work + " ms"
                    + (rows.values("substeps").size() > 1 ? ", substeps " + named(substeps) : "")
                    + (kicks.equals("0") ? "" : ", " + kicks + " set")
                    + (background.equals("true") ? ", background" : "");
        }
    }

    /** As the class comment says. */
    public static void main(String[] arguments) throws IOException, CommandLineOptionException {
        Args args = Args.parse(arguments, "work", "substeps", "background", "kicks");
        Path folder = args.folder();
        Rows rows = new Rows(
                folder.resolve("frame.csv"),
                6,
                "device",
                "substeps",
                "background",
                "kicks",
                "work",
                "circles",
                "frame ms",
                "step us",
                "snapshot us",
                "wait us",
                "gc B/op",
                "heap B");
        if (!args.drawOnly()) {
            rows.measure("Circles2D " + Machine.version("io.github.circles2d", "circles2d") + ", JMH "
                    + Machine.version("org.openjdk.jmh", "jmh-core"));
            for (ComputeDevice device : Machine.devices(args)) {
                for (String substeps : args.list("substeps", "8")) {
                    for (String background : args.list("background", "false", "true")) {
                        for (String kicks : args.list("kicks", "0")) {
                            for (String work : args.list("work", "0", "1", "4", "10")) {
                                Way way = new Way(Machine.label(device), substeps, background, kicks, work);
                                measure(args, rows, device, way);
                            }
                        }
                    }
                }
            }
        }
        write(rows, folder);
    }

    private static void measure(Args args, Rows rows, ComputeDevice device, Way way)
            throws IOException, CommandLineOptionException {
        int limit = args.limit(60);
        double frame = 0;
        int before = 1;
        for (int circles : args.numbers("circles", "1000", "10000", "100000", "1000000")) {
            double expected = frame / 1000 * circles / before;
            // ten steps to settle, and a frame at least
            if (expected * 11 > limit) {
                rows.put(way.row(circles, "left out: expected to take more than " + limit + " s"));
                continue;
            }
            Map<String, String> parameters = new LinkedHashMap<>();
            parameters.put("device", Machine.index(device));
            parameters.put("circles", String.valueOf(circles));
            parameters.put("work", way.work);
            parameters.put("kicks", way.kicks);
            parameters.put("substeps", way.substeps);
            parameters.put("background", way.background);
            double iteration = expected == 0 ? 0 : Math.max(1, expected);
            JmhCell cell =
                    JmhCell.run(FrameStep.class, args, parameters, iteration, limit - (int) (expected * 10), "gc");
            if (cell.failure() != null) {
                rows.put(way.row(circles, cell.failure()));
                // larger ones would do no better
                frame = Double.MAX_VALUE;
                continue;
            }
            frame = cell.score();
            before = circles;
            double frames = cell.secondary("frames");
            double step = cell.secondary("stepNanos") / frames / 1000;
            double snapshot = cell.secondary("snapshotNanos") / frames / 1000;
            rows.put(way.row(
                    circles,
                    frame,
                    step,
                    snapshot,
                    step + snapshot,
                    cell.secondary("gc.alloc.rate.norm"),
                    cell.secondary("heapBytes") / frames));
        }
    }

    private static void write(Rows rows, Path folder) throws IOException {
        Markdown page = Markdown.page("What a game pays for a frame", rows)
                .paragraph(
                        "step(), some work of the game's own on the same thread, snapshot(): a pile that lies ready, grid(),"
                                + " SMALL_STEPS. Before it, the game sets the velocity of some circles. Wait is the time in the two"
                                + " calls. In the background, a thread of the world's own makes the steps. Bytes from the heap: what JMH's profiler sees, its"
                                + " own included, and what the game's thread takes in the two calls.")
                .table(
                        1,
                        "device",
                        "substeps",
                        "background",
                        "velocities set",
                        "circles",
                        "work, ms",
                        "frame, ms",
                        "step(), us",
                        "snapshot(), us",
                        "wait, us",
                        "B a frame, profiler",
                        "B a frame, thread");
        Chart chart = new Chart("What a game's thread waits in a frame", "step() and snapshot(), ms");
        List<Integer> circles = rows.numbers("circles");
        List<Integer> works = rows.numbers("work");
        for (String device : rows.values("device")) {
            for (String substeps : rows.values("substeps")) {
                for (String background : rows.values("background")) {
                    for (String kicks : rows.values("kicks")) {
                        for (int n : circles) {
                            for (int work : works) {
                                new Way(device, substeps, background, kicks, "" + work)
                                        .in(rows, n)
                                        .ifPresent(row -> add(page, row));
                            }
                        }
                        for (int work : works) {
                            line(chart, rows, circles, new Way(device, substeps, background, kicks, "" + work));
                        }
                    }
                }
            }
        }
        chart.save(folder.resolve("frame.png"));
        page.picture("What a game's thread waits in a frame", "frame.png").save(folder.resolve("frame.md"));
    }

    private static void line(Chart chart, Rows rows, List<Integer> circles, Way way) {
        int colour = rows.values("device").indexOf(way.device)
                        * rows.values("background").size()
                + rows.values("background").indexOf(way.background);
        int stroke = (rows.values("substeps").indexOf(way.substeps)
                                        * rows.values("kicks").size()
                                + rows.values("kicks").indexOf(way.kicks))
                        * rows.values("work").size()
                + rows.values("work").indexOf(way.work);
        chart.line(
                way.label(rows),
                colour,
                stroke,
                circles,
                circles.stream()
                        .map(n -> way.in(rows, n)
                                .map(row -> thousandth(row.get("wait us")))
                                .orElse(""))
                        .toList());
    }

    private static String named(String substeps) {
        return substeps.equals("0") ? "auto" : substeps;
    }

    private static void add(Markdown page, Map<String, String> row) {
        page.row(
                row.get("device"),
                named(row.get("substeps")),
                row.get("background").equals("true") ? "yes" : "no",
                row.get("kicks"),
                Markdown.count(row.get("circles")),
                row.get("work"),
                Markdown.figure(row.get("frame ms")),
                Markdown.figure(row.get("step us")),
                Markdown.figure(row.get("snapshot us")),
                Markdown.figure(row.get("wait us")),
                Markdown.figure(row.get("gc B/op")),
                Markdown.figure(row.get("heap B")));
    }

    private static String thousandth(String value) {
        return value.isEmpty() ? "" : String.valueOf(Double.parseDouble(value) / 1000);
    }
}
