package io.github.circles2d.demo;

import io.github.circles2d.Circles2DException;
import io.github.circles2d.ComputeDevice;
import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/**
 * Circles in a window, or without a display the same circles in a picture and a summary.
 *
 * <pre>{@code
 * mvn -q compile exec:java
 * mvn -q compile exec:java -Dexec.args="--headless --circles 5000 --device host"
 * }</pre>
 *
 * <p>Ends with status 0, 1 if the device or the picture failed, 2 if the command line is wrong.
 */
public final class Demo {
    private static final int FAILED = 1;
    private static final int MISUSED = 2;

    private Demo() {}

    public static void main(String[] arguments) throws Exception {
        if (List.of(arguments).contains("--headless")) {
            // before AWT starts: it is not to load what a display needs
            System.setProperty("java.awt.headless", "true");
        }
        int status = run(System.out, System.err, arguments);
        if (status != 0) {
            System.exit(status);
        }
    }

    /** The demo, without the end of the process; returns its status. */
    static int run(PrintStream out, PrintStream err, String... arguments) throws Exception {
        Options options;
        Setup setup;
        try {
            options = Options.parse(arguments);
            if (options.help) {
                out.print(Options.HELP);
                return 0;
            }
            if (options.list) {
                list(out);
                return 0;
            }
            setup = options.setup(options.device());
        } catch (IllegalArgumentException e) {
            err.println(e.getMessage());
            err.println("--help lists the options");
            return MISUSED;
        } catch (Circles2DException e) {
            err.println(describe(e));
            return FAILED;
        }
        try {
            return options.headless || GraphicsEnvironment.isHeadless()
                    ? headless(options, setup, out)
                    : window(options, setup, out, err);
        } catch (Circles2DException | UncheckedIOException | OutOfMemoryError e) {
            err.println(describe(e));
            return FAILED;
        }
    }

    private static void list(PrintStream out) {
        List<ComputeDevice> devices = ComputeDevice.list();
        for (int index = 0; index < devices.size(); index++) {
            ComputeDevice device = devices.get(index);
            out.printf(
                    Locale.ROOT,
                    "%d  %-11s %-17s %s (%s)%n",
                    index,
                    device.type(),
                    device.deterministic() ? "deterministic" : "not deterministic",
                    device.name(),
                    device.platform());
        }
    }

    private static int headless(Options options, Setup setup, PrintStream out) {
        Path picture = options.headlessPicture(Path.of(""));
        SimulationRun.run(setup, options.headlessSteps(), picture, out).print(out);
        SimulationRun.line(out, "picture", picture.toString());
        return 0;
    }

    private static int window(Options options, Setup setup, PrintStream out, PrintStream err) throws Exception {
        Path picture = options.windowPicture();
        if (picture != null) {
            Pictures.prepare(picture);
        }
        Window window;
        try {
            window = Window.open(setup, options.windowSteps());
        } catch (AWTError | HeadlessException | LinkageError e) {
            err.println("no window, going on without: " + e.getMessage());
            return headless(options, setup, out);
        }
        // this is the simulation's thread from here on
        return window.run(picture, out, err) ? 0 : FAILED;
    }

    /** A failure in words for the user. */
    static String describe(Throwable failure) {
        return failure instanceof OutOfMemoryError
                ? "not enough memory: " + failure.getMessage() + " (raise -Xmx, or take fewer circles)"
                : failure.getMessage();
    }
}
