package io.github.circles2d.bench;

import io.github.circles2d.ComputeDevice;
import java.io.BufferedOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.openjdk.jmh.util.ListStatistics;

/**
 * From nothing to the first step: 1,000 to 1,000,000 circles of the scene {@code pile}, {@code grid()}, {@code SMALL_STEPS} at 8
 * substeps, on every device, in a fresh JVM each time. Milliseconds to list the devices, to build a world, to add all circles to it in one call, and
 * for the first two steps, each with its read-back. Twice: {@code cold}, the driver has not compiled these kernels before, its cache
 * being an empty folder; and {@code warm}, it has. Drivers that keep their cache elsewhere than NVIDIA's and PoCL leave the folder empty,
 * and cold means nothing there: the table has its size. Written into a folder as {@code start.md}, {@code .png} and {@code .csv}. A
 * JVM that takes longer than {@code --limit} seconds (120) is ended and named.
 *
 * <pre>{@code
 * mvn -q -Pbench verify -Dbench.args="Start"
 * mvn -q -Pbench verify -Dbench.args="Start --device gpu --circles 1000000 --repeats 5 --out target/start"
 * }</pre>
 *
 * <p>{@code --repeats} is how many times each is done (3); medians count. Figures are added to those that are in the folder;
 * {@code --draw} measures nothing.
 */
public final class Start {
    private static final List<String> FIGURES = List.of(
            "ready ms",
            "least ms",
            "most ms",
            "list ms",
            "circles ms",
            "build ms",
            "add ms",
            "first ms",
            "second ms",
            "runs",
            "cache KiB");
    private static final int PHASES = 6;
    /** From this phase on to {@link #FIRST} a world becomes ready. */
    private static final int BUILD = 2;

    private static final int FIRST = 4;

    /** What is known of one device, cache and number of circles. */
    private static final class Runs {
        private final List<ListStatistics> phases =
                Stream.generate(ListStatistics::new).limit(PHASES).toList();
        private final ListStatistics ready = new ListStatistics();
        private long cached;

        void add(List<String> result, long bytes) {
            double[] ms = result.stream().mapToDouble(Double::parseDouble).toArray();
            for (int i = 0; i < ms.length; i++) {
                phases.get(i).addValue(ms[i]);
            }
            ready.addValue(Arrays.stream(ms, BUILD, FIRST + 1).sum());
            cached = bytes;
        }

        void put(Rows rows, String device, String cache, int circles) {
            List<Object> row = new ArrayList<>(List.of(device, cache, circles));
            row.addAll(List.of(ready.getPercentile(50), ready.getMin(), ready.getMax()));
            phases.forEach(ms -> row.add(ms.getPercentile(50)));
            row.addAll(List.of(ready.getN(), cached / 1024));
            rows.put(row.toArray());
        }
    }

    private Start() {}

    /** As the class comment says. */
    public static void main(String[] arguments) throws IOException {
        Args args = Args.parse(arguments, "repeats").withoutJmh();
        Path folder = args.folder();
        Rows rows = new Rows(
                folder.resolve("start.csv"),
                3,
                Stream.concat(Stream.of("device", "cache", "circles"), FIGURES.stream())
                        .toArray(String[]::new));
        if (!args.drawOnly()) {
            rows.measure("Circles2D " + Machine.version("io.github.circles2d", "circles2d"));
            for (int circles : args.numbers("circles", "1000", "100000", "1000000")) {
                Path file = Files.createTempFile("circles", "");
                try {
                    write(Layout.start(circles).circles(), file);
                    for (ComputeDevice device : Machine.devices(args)) {
                        measure(args, rows, device, circles, file);
                    }
                } finally {
                    Files.delete(file);
                }
            }
        }
        write(rows, folder);
    }

    private static void write(float[] circles, Path file) throws IOException {
        try (ObjectOutputStream out = new ObjectOutputStream(new BufferedOutputStream(Files.newOutputStream(file)))) {
            out.writeObject(circles);
        }
    }

    private static void measure(Args args, Rows rows, ComputeDevice device, int circles, Path file) throws IOException {
        String name = Machine.label(device);
        Map<String, Runs> states = new LinkedHashMap<>();
        for (String state : device.type() == ComputeDevice.Type.HOST ? List.of("none") : List.of("cold", "warm")) {
            states.put(state, new Runs());
        }
        int repeats = args.numbers("repeats", "3").get(0);
        for (int repeat = 0; repeat < repeats; repeat++) {
            Path cache = Files.createTempDirectory("kernels");
            Map<String, String> environment = Map.of(
                    "CUDA_CACHE_PATH", cache.toString(),
                    "CUDA_CACHE_DISABLE", "0",
                    "POCL_CACHE_DIR", cache.toString());
            try {
                for (Map.Entry<String, Runs> state : states.entrySet()) {
                    List<String> result =
                            Child.run(environment, StartCase.class, args.limit(120), Machine.index(device), file);
                    if (result.size() == 1) {
                        rows.put(name, state.getKey(), circles, result.get(0));
                        return;
                    }
                    state.getValue().add(result, bytes(cache));
                }
            } finally {
                delete(cache);
            }
        }
        states.forEach((state, runs) -> runs.put(rows, name, state, circles));
    }

    private static long bytes(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.map(Path::toFile)
                    .filter(File::isFile)
                    .mapToLong(File::length)
                    .sum();
        }
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        }
    }

    private static void write(Rows rows, Path folder) throws IOException {
        Markdown page = Markdown.page("From nothing to the first step", rows)
                .paragraph(
                        "The scene pile, grid(), SMALL_STEPS at 8 substeps, in a fresh JVM each time; milliseconds, medians."
                                + " Cold: the driver's cache of compiled kernels is an empty folder (its size afterwards is the last"
                                + " column). Warm: the same folder again. A world and its first step: building the world, adding all"
                                + " circles (addCircles), the first step and its read-back; least and most of all runs. Listing the devices, the first"
                                + " call, loads OpenCL. The circles come from a file, so that none of the library has run before; reading"
                                + " it counts to none of the others.")
                .table(
                        2,
                        "device",
                        "cache",
                        "circles",
                        "a world and its first step",
                        "least",
                        "most",
                        "list devices",
                        "read circles",
                        "build",
                        "add circles",
                        "first step",
                        "second step",
                        "runs",
                        "cache, KiB");
        Chart chart = new Chart("From nothing to the first step", "ms, a world and its first step");
        List<Integer> circles = rows.numbers("circles");
        List<String> caches = List.of("none", "cold", "warm");
        for (String device : rows.values("device")) {
            for (String cache : caches) {
                circles.forEach(n -> rows.row(device, cache, n).ifPresent(row -> add(page, row)));
                chart.line(
                        device + (cache.equals("none") ? "" : ", " + cache),
                        rows.values("device").indexOf(device),
                        caches.indexOf(cache),
                        circles,
                        circles.stream()
                                .map(n -> rows.row(device, cache, n)
                                        .map(row -> row.get("ready ms"))
                                        .orElse(""))
                                .toList());
            }
        }
        chart.save(folder.resolve("start.png"));
        page.picture("Milliseconds for a world and its first step", "start.png").save(folder.resolve("start.md"));
    }

    private static void add(Markdown page, Map<String, String> row) {
        List<Object> cells =
                new ArrayList<>(List.of(row.get("device"), row.get("cache"), Markdown.count(row.get("circles"))));
        FIGURES.forEach(
                column -> cells.add(column.endsWith(" ms") ? Markdown.figure(row.get(column)) : row.get(column)));
        page.row(cells.toArray());
    }
}
