package io.github.circles2d.bench;

import io.github.circles2d.ComputeDevice;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
 * <p>Further names: {@code --substeps} (8), {@code --background} (false,true: whether the world makes its steps on a thread of its
 * own). What else there is goes to JMH. Figures are added to those that are in the folder;
 * {@code --draw} measures nothing.
 */
public final class Frame {
    private Frame() {}

    /** As the class comment says. */
    public static void main(String[] arguments) throws IOException, CommandLineOptionException {
        Args args = Args.parse(arguments, "work", "substeps", "background");
        Path folder = args.folder();
        Rows rows = new Rows(
                folder.resolve("frame.csv"),
                5,
                "device",
                "substeps",
                "background",
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
                        for (String work : args.list("work", "0", "1", "4", "10")) {
                            measure(args, rows, device, substeps, background, work);
                        }
                    }
                }
            }
        }
        write(rows, folder);
    }

    private static void measure(
            Args args, Rows rows, ComputeDevice device, String substeps, String background, String work)
            throws IOException, CommandLineOptionException {
        String name = Machine.label(device);
        int limit = args.limit(60);
        double frame = 0;
        int before = 1;
        for (int circles : args.numbers("circles", "1000", "10000", "100000", "1000000")) {
            double expected = frame / 1000 * circles / before;
            // ten steps to settle, and a frame at least
            if (expected * 11 > limit) {
                rows.put(
                        name,
                        substeps,
                        background,
                        work,
                        circles,
                        "left out: expected to take more than " + limit + " s");
                continue;
            }
            Map<String, String> parameters = new LinkedHashMap<>();
            parameters.put("device", Machine.index(device));
            parameters.put("circles", String.valueOf(circles));
            parameters.put("work", work);
            parameters.put("substeps", substeps);
            parameters.put("background", background);
            double iteration = expected == 0 ? 0 : Math.max(1, expected);
            JmhCell cell =
                    JmhCell.run(FrameStep.class, args, parameters, iteration, limit - (int) (expected * 10), "gc");
            if (cell.failure() != null) {
                rows.put(name, substeps, background, work, circles, cell.failure());
                // larger ones would do no better
                frame = Double.MAX_VALUE;
                continue;
            }
            frame = cell.score();
            before = circles;
            double frames = cell.secondary("frames");
            double step = cell.secondary("stepNanos") / frames / 1000;
            double snapshot = cell.secondary("snapshotNanos") / frames / 1000;
            rows.put(
                    name,
                    substeps,
                    background,
                    work,
                    circles,
                    frame,
                    step,
                    snapshot,
                    step + snapshot,
                    cell.secondary("gc.alloc.rate.norm"),
                    cell.secondary("heapBytes") / frames);
        }
    }

    private static void write(Rows rows, Path folder) throws IOException {
        Markdown page = Markdown.page("What a game pays for a frame", rows)
                .paragraph(
                        "step(), some work of the game's own on the same thread, snapshot(): a pile that lies ready, grid(),"
                                + " SMALL_STEPS. Wait is the time in the two calls. In the background, a thread of the world's own makes"
                                + " the steps. Bytes from the heap: what JMH's profiler sees, its"
                                + " own included, and what the game's thread takes in the two calls.")
                .table(
                        1,
                        "device",
                        "substeps",
                        "background",
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
                    for (int n : circles) {
                        for (int work : works) {
                            rows.row(device, substeps, background, work, n).ifPresent(row -> add(page, row));
                        }
                    }
                    for (int work : works) {
                        line(chart, rows, circles, device, substeps, background, work);
                    }
                }
            }
        }
        chart.save(folder.resolve("frame.png"));
        page.picture("What a game's thread waits in a frame", "frame.png").save(folder.resolve("frame.md"));
    }

    private static void line(
            Chart chart,
            Rows rows,
            List<Integer> circles,
            String device,
            String substeps,
            String background,
            int work) {
        int colour = rows.values("device").indexOf(device)
                        * rows.values("background").size()
                + rows.values("background").indexOf(background);
        int stroke =
                rows.values("substeps").indexOf(substeps) * rows.numbers("work").size()
                        + rows.numbers("work").indexOf(work);
        chart.line(
                device + ", work " + work + " ms"
                        + (rows.values("substeps").size() > 1 ? ", substeps " + named(substeps) : "")
                        + (background.equals("true") ? ", background" : ""),
                colour,
                stroke,
                circles,
                circles.stream()
                        .map(n -> rows.row(device, substeps, background, work, n)
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
