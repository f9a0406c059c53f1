package io.github.circles2d.demo;

import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import io.github.circles2d.pipeline.Tuning;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;

/** The command line of {@link Demo}. */
final class Options {
    static final String HELP = """
            Circles2D: rigid circles in a box, in a window, or headless into a picture and a summary.

              --scene NAME         thesis (default), gas, pile, mixed, pebbles, column, loaded, bullets or dam
              --circles N          number of circles, default 1250
              --device NAME|INDEX  where it runs: gpu, cpu, host, a part of a name, or an index of --list
              --solver NAME        small_steps (default, piles that stand) or impulse (the thesis' rule)
              --substeps N         substeps of a step of small_steps; without it they are chosen before each step
              --strategy NAME      formula, pair_table, row_search, folded, grid or auto; default folded
                                   with impulse, else grid
              --store NAME         compact (default) or triangle
              --steps N            end after N steps; headless or with --screenshot the default is 1200
              --screenshot FILE    save a picture at the end, FILE.png
              --headless           no window; also the way where no display can be opened
              --list               list the devices and end
              --help               print this and end
            """;

    private static final int MAX_STEPS = 10_000_000;
    private static final int DEFAULT_STEPS = 1200;

    Scene scene = Scene.THESIS;
    int circles = Scene.THESIS_CIRCLES;
    Solver solver = Solver.SMALL_STEPS;
    int substeps;
    CollisionStore store = CollisionStore.COMPACT;
    boolean headless;
    boolean list;
    boolean help;

    private IndexStrategy strategy;
    private String device;
    private int steps;
    private Path screenshot;

    private Options() {}

    /**
     * Reads a command line; of an option given twice the last counts.
     *
     * @throws IllegalArgumentException if it is wrong; the message says how
     */
    static Options parse(String... arguments) {
        Options options = new Options();
        Iterator<String> rest = List.of(arguments).iterator();
        while (rest.hasNext()) {
            String option = rest.next();
            switch (option) {
                case "--scene" -> options.scene = Scene.named(value(option, rest));
                case "--circles" -> options.circles = number(option, rest, Tuning.MAX_CIRCLES);
                case "--device" -> options.device = value(option, rest);
                case "--strategy" -> options.strategy = IndexStrategy.named(value(option, rest));
                case "--solver" -> options.solver = solver(value(option, rest));
                case "--substeps" -> options.substeps = number(option, rest, Tuning.MAX_SUBSTEPS);
                case "--store" -> options.store = store(value(option, rest));
                case "--steps" -> options.steps = number(option, rest, MAX_STEPS);
                case "--screenshot" -> options.screenshot = picture(value(option, rest));
                case "--headless" -> options.headless = true;
                case "--list" -> options.list = true;
                case "--help", "-h" -> options.help = true;
                default -> throw new IllegalArgumentException("unknown option " + option);
            }
        }
        return options;
    }

    private static String value(String option, Iterator<String> rest) {
        if (!rest.hasNext()) {
            throw new IllegalArgumentException(option + " needs a value");
        }
        return rest.next();
    }

    private static int number(String option, Iterator<String> rest, int most) {
        String value = value(option, rest);
        // up to nine digits always fit an int
        int number = value.matches("\\d{1,9}") ? Integer.parseInt(value) : 0;
        if (number < 1 || number > most) {
            throw new IllegalArgumentException(option + " = " + value + ": must be a whole number from 1 to " + most);
        }
        return number;
    }

    private static Solver solver(String name) {
        return switch (name) {
            case "impulse" -> Solver.IMPULSE;
            case "small_steps" -> Solver.SMALL_STEPS;
            default ->
                throw new IllegalArgumentException("solver = " + name + ": must be one of [impulse, small_steps]");
        };
    }

    private static CollisionStore store(String name) {
        return switch (name) {
            case "compact" -> CollisionStore.COMPACT;
            case "triangle" -> CollisionStore.TRIANGLE;
            default -> throw new IllegalArgumentException("store = " + name + ": must be one of [compact, triangle]");
        };
    }

    private static Path picture(String file) {
        if (!file.toLowerCase(Locale.ROOT).endsWith(".png")) {
            throw new IllegalArgumentException("--screenshot = " + file + ": must end in .png");
        }
        return Path.of(file);
    }

    /** The strategy that is asked for, or the one that suits the solver. */
    IndexStrategy strategy() {
        if (strategy != null) {
            return strategy;
        }
        return solver == Solver.SMALL_STEPS ? IndexStrategy.grid() : IndexStrategy.folded();
    }

    /** The device that is asked for, or the preferred one. */
    ComputeDevice device() {
        return device == null
                ? ComputeDevice.preferred()
                : ComputeDevice.find(device)
                        .orElseThrow(() -> new IllegalArgumentException(
                                "--device = " + device + ": no such device; --list shows those of this machine"));
    }

    /** The world that is asked for, on a device. */
    Setup setup(ComputeDevice on) {
        return new Setup(scene, circles, solver, substeps, strategy(), store, on);
    }

    /** Steps of a headless run. */
    int headlessSteps() {
        return steps > 0 ? steps : DEFAULT_STEPS;
    }

    /** Steps after which the window ends; 0 for never. */
    int windowSteps() {
        return screenshot == null ? steps : headlessSteps();
    }

    /** Where a window saves its picture, or null. */
    Path windowPicture() {
        return screenshot;
    }

    /** Where a headless run in {@code folder} saves its picture. */
    Path headlessPicture(Path folder) {
        if (screenshot != null) {
            return screenshot;
        }
        Path target = folder.resolve("target");
        return (target.toFile().isDirectory() ? target : folder).resolve("circles2d.png");
    }
}
