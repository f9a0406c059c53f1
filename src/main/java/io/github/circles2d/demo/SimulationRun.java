package io.github.circles2d.demo;

import io.github.circles2d.Circles2D;
import io.github.circles2d.Snapshot;
import java.awt.image.BufferedImage;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;

/** A run without a window: progress each second, then a picture and a summary. */
final class SimulationRun {
    private static final int PICTURE_SIDE = 640;
    private static final long PROGRESS_NANOS = 1_000_000_000L;

    /** What a run ends with; times are of one step and a snapshot after it, as a game takes each frame. */
    record Summary(Setup setup, int steps, double medianMillis, double slowMillis, long contacts, long hash) {
        void print(PrintStream out) {
            line(out, "device", setup.device().toString());
            line(out, "scene", setup.scene().name());
            line(out, "solver", setup.solver().name().toLowerCase(Locale.ROOT));
            line(out, "strategy", setup.strategy().name());
            line(out, "store", setup.store().name().toLowerCase(Locale.ROOT));
            line(out, "circles", text("%,d", setup.circles()));
            line(out, "steps", text("%,d", steps));
            line(out, "median", text("%.3f ms a step", medianMillis));
            line(out, "99 %", text("%.3f ms a step", slowMillis));
            line(out, "contacts", text("%,d in the last step", contacts));
            line(out, "hash", text("%016x", hash));
        }
    }

    private SimulationRun() {}

    /** Runs, saves the picture and returns what there is to say. */
    static Summary run(Setup setup, int steps, Path file, PrintStream out) {
        Pictures.prepare(file);
        try (Circles2D world = setup.build()) {
            long[] nanos = new long[steps];
            long told = System.nanoTime();
            int toldStep = 0;
            for (int step = 0; step < steps; step++) {
                long start = System.nanoTime();
                world.step();
                world.snapshot();
                long now = System.nanoTime();
                nanos[step] = now - start;
                if (now - told >= PROGRESS_NANOS) {
                    double millis = (now - told) / 1e6 / (step + 1 - toldStep);
                    long contacts = world.stats().contacts();
                    out.println(
                            text("step %,d of %,d, %.2f ms a step, %,d contacts", step + 1, steps, millis, contacts));
                    told = System.nanoTime();
                    toldStep = step + 1;
                }
            }
            save(world.snapshot(), file);
            Arrays.sort(nanos);
            double median = nanos[steps / 2] / 1e6;
            double slow = nanos[(int) (steps * 0.99)] / 1e6;
            return new Summary(setup, steps, median, slow, world.stats().contacts(), world.stateHash());
        }
    }

    private static void save(Snapshot now, Path file) {
        BufferedImage picture = Painter.picture(PICTURE_SIDE, PICTURE_SIDE);
        Painter.paint(Frame.of(now), picture);
        Pictures.save(picture, file);
    }

    /** A line of the summary. */
    static void line(PrintStream out, String name, String value) {
        out.println(text("%-9s %s", name, value));
    }

    private static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
