package io.github.circles2d.bench;

import io.github.circles2d.ComputeDevice;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * The scene {@code pile} in other engines that a Java game can use: dyn4j, JBox2D and libGDX's Box2D, beside Circles2D on every device.
 * A squashed pile is not a fast one: each row says how well the circles stand. Written into a folder as {@code peers.md},
 * {@code .png} (milliseconds), {@code peers-overlap.png} and {@code .csv}. A row ends after 900 steps or {@code --limit} seconds (300)
 * and says after how many; one that would have no pile by then is left out and named.
 *
 * <pre>{@code
 * mvn -q -Pbench verify -Dbench.args="Peers"
 * mvn -q -Pbench verify -Dbench.args="Peers --engine libgdx,circles2d --device host --circles 1250 --steps 300 --out target/peers"
 * }</pre>
 *
 * <p>Further names: {@code --substeps} (0, the world's choice, and 8). Figures are added to those that are in the folder;
 * {@code --draw} measures nothing.
 */
public final class Peers {
    /** What is measured of each engine and size. */
    private static final List<String> FIGURES = List.of(
            "falling ms",
            "piled ms",
            "steps",
            "contacts",
            "mean overlap",
            "max overlap",
            "energy",
            "height",
            "outside");

    private Peers() {}

    /** As the class comment says. */
    public static void main(String[] arguments) throws IOException {
        Args args = Args.parse(arguments, "engine", "substeps", "steps").withoutJmh();
        Path folder = args.folder();
        Rows rows = new Rows(
                folder.resolve("peers.csv"),
                2,
                Stream.concat(Stream.of("engine", "circles"), FIGURES.stream()).toArray(String[]::new));
        if (!args.drawOnly()) {
            rows.measure("Circles2D " + Machine.version("io.github.circles2d", "circles2d") + ", dyn4j "
                    + org.dyn4j.Version.getVersion() + ", JBox2D "
                    + Machine.version("org.jbox2d", "jbox2d-library") + ", libGDX "
                    + com.badlogic.gdx.Version.VERSION);
            measure(args, rows);
        }
        write(rows, folder);
    }

    private static void measure(Args args, Rows rows) throws IOException {
        Map<String, String> engines = engines(args);
        int limit = args.limit(300);
        int steps = args.numbers("steps", "900").get(0);
        for (int circles : args.numbers("circles", "1250", "5000", "15000", "50000")) {
            for (Map.Entry<String, String> engine : engines.entrySet()) {
                List<Object> row = new ArrayList<>(List.of(engine.getKey(), circles));
                if (expected(rows, engine.getKey(), circles, steps) > limit) {
                    row.add("left out: a pile is expected to take more than " + limit + " s");
                } else {
                    // it ends by itself after the limit, if its step ends at all
                    row.addAll(Child.run(PeerCase.class, 2 * limit + 30, engine.getValue(), circles, steps, limit));
                }
                rows.put(row.toArray());
            }
        }
    }

    /** Seconds until there is a pile to time: its steps grow as they have from one number of circles to the next. */
    private static double expected(Rows rows, String engine, int circles, int steps) {
        double circlesBefore = 0;
        double ms = 0;
        double growth = 1;
        for (int n : rows.numbers("circles")) {
            Map<String, String> row = rows.row(engine, n).orElse(Map.of());
            if (n >= circles || row.isEmpty()) {
                continue;
            }
            if (row.get("piled ms").isEmpty()) {
                // fewer circles had no time to pile up, unless that was not asked for
                return row.get("steps").equals(String.valueOf(steps)) ? 0 : Double.POSITIVE_INFINITY;
            }
            double piled = Double.parseDouble(row.get("piled ms"));
            growth = ms > 0 ? Math.max(1, Math.log(piled / ms) / Math.log(n / circlesBefore)) : 1;
            circlesBefore = n;
            ms = piled;
        }
        return ms == 0 ? 0 : PeerCase.PILE * ms / 1000 * Math.pow(circles / circlesBefore, growth);
    }

    /** The rows of one size: what the table calls them, and what {@link PeerCase} does. */
    private static Map<String, String> engines(Args args) {
        Map<String, String> engines = new LinkedHashMap<>();
        for (String engine : args.list("engine", "dyn4j", "jbox2d", "libgdx", "circles2d")) {
            switch (engine) {
                case "dyn4j" -> engines.put("dyn4j", engine);
                case "jbox2d" -> engines.put("JBox2D", engine);
                case "libgdx" -> engines.put("libGDX's Box2D", engine);
                case "circles2d" -> {
                    for (ComputeDevice device : Machine.devices(args)) {
                        for (String substeps : args.list("substeps", "0", "8")) {
                            engines.put(
                                    "Circles2D, " + Machine.label(device)
                                            + (substeps.equals("0") ? ", auto" : ", " + substeps),
                                    Machine.index(device) + ":" + substeps);
                        }
                    }
                }
                default ->
                    throw new IllegalArgumentException(
                            "engine = " + engine + ": must be one of [dyn4j, jbox2d, libgdx, circles2d]");
            }
        }
        return engines;
    }

    private static void write(Rows rows, Path folder) throws IOException {
        Markdown page = Markdown.page("A pile in other engines", rows)
                .paragraph(
                        "The scene pile: circles at rest all over a box fall and make a pile; no friction, restitution 0.5, 1/60 s"
                                + " a step, no sleep. Circles2D: grid(), SMALL_STEPS, so many substeps or as many as the world chooses"
                                + " (auto); its time includes the read-back of all circles. The others: lengths, speeds and gravity"
                                + " scaled to a mean radius of 0.5, so that the motion is the same; their default iterations; their"
                                + " continuous collision is off, since it can hang in a pile; nothing bounces below the speed that gravity"
                                + " adds in four steps (JBox2D: below 1, a constant). libGDX and JBox2D never move a body by more than"
                                + " 2 in a step: large piles fall more slowly there. Reading their bodies is not timed.")
                .paragraph(
                        "Falling: the first " + PeerCase.FALLING + " steps. Piled: the last " + PeerCase.PILED
                                + " of all steps, or the last fifth of fewer; empty where time ended before a pile could form. Overlaps are fractions of the smaller"
                                + " radius over the pairs that overlap; energy is the sum of m v^2 / 2 over the sum of m g r; 99 % of the"
                                + " centres lie below the height; outside are circles that reach through a wall whole; all of the last step.")
                .table(
                        2,
                        "circles",
                        "engine",
                        "falling, ms a step",
                        "piled, ms a step",
                        "steps",
                        "contacts",
                        "mean overlap",
                        "max overlap",
                        "energy",
                        "height",
                        "outside");
        Chart time = new Chart("A pile in other engines", "piled, ms a step");
        Chart overlap = new Chart("What the pile looks like", "mean overlap, of the smaller radius");
        List<Integer> circles = rows.numbers("circles");
        List<String> engines = rows.values("engine");
        for (int n : circles) {
            for (String engine : engines) {
                rows.row(engine, n).ifPresent(row -> add(page, row));
            }
        }
        for (int i = 0; i < engines.size(); i++) {
            String engine = engines.get(i);
            int stroke = engine.startsWith("Circles2D") ? 0 : 1;
            time.line(engine, i, stroke, circles, values(rows, engine, circles, "piled ms"));
            overlap.line(engine, i, stroke, circles, values(rows, engine, circles, "mean overlap"));
        }
        time.save(folder.resolve("peers.png"));
        overlap.save(folder.resolve("peers-overlap.png"));
        page.picture("Milliseconds a step", "peers.png")
                .picture("Mean overlap", "peers-overlap.png")
                .save(folder.resolve("peers.md"));
    }

    private static List<String> values(Rows rows, String engine, List<Integer> circles, String column) {
        return circles.stream()
                .map(n -> rows.row(engine, n).map(row -> row.get(column)).orElse(""))
                .toList();
    }

    private static void add(Markdown page, Map<String, String> row) {
        List<Object> cells = new ArrayList<>(List.of(Markdown.count(row.get("circles")), row.get("engine")));
        FIGURES.forEach(column -> cells.add(
                column.equals("steps") || column.equals("outside")
                        ? row.get(column)
                        : Markdown.figure(row.get(column))));
        page.row(cells.toArray());
    }
}
