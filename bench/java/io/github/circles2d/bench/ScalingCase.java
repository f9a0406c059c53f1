package io.github.circles2d.bench;

import io.github.circles2d.Circles2D;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import io.github.circles2d.StepStats;
import org.openjdk.jmh.util.ListStatistics;

/** One figure of {@link Scaling}, in a JVM of its own. */
final class ScalingCase {
    private static final int WARM_CIRCLES = 10_000;
    private static final int STEPS = 10;
    private static final int ROUNDS = 5;

    private final ComputeDevice device;
    private final int substeps;
    private final boolean packed;
    private final int settle;
    private final long end;

    private ScalingCase(String[] args) {
        device = Machine.device(args[0]);
        substeps = Integer.parseInt(args[2]);
        packed = args[3].equals("packed");
        settle = Integer.parseInt(args[4]);
        end = System.nanoTime() + Long.parseLong(args[5]) * 1_000_000_000L;
    }

    /** Takes the device, circles, substeps (0: the world's choice), {@code start} or {@code packed}, steps before, and seconds. */
    public static void main(String[] args) {
        new ScalingCase(args).run(Integer.parseInt(args[1]));
    }

    private void run(int circles) {
        warmUp(layout(Math.min(circles, WARM_CIRCLES)));
        Layout layout = layout(circles);
        ListStatistics ms = new ListStatistics();
        int rounds = 0;
        int before = 0;
        int timed = 0;
        double ready = 0;
        StepStats stats = null;
        long bytes = 0;
        // as many rounds as half of the time holds
        long begun = System.nanoTime();
        while (rounds < ROUNDS && (rounds == 0 || 2 * (System.nanoTime() - begun) < end - begun)) {
            long built = System.nanoTime();
            try (Circles2D world = layout.world(builder())) {
                time(world, 1);
                double second = (System.nanoTime() - built) / 1e9;
                ready = rounds == 0 ? second : Math.min(ready, second);
                // every round takes the steps of the first, which has half of the time for those before
                long half = (System.nanoTime() + end) / 2;
                double step = 0;
                int done = 1;
                while (done < (rounds == 0 ? Math.max(2, settle) : before) && (step == 0 || System.nanoTime() < half)) {
                    step = time(world, 1);
                    done++;
                }
                if (rounds == 0) {
                    before = done;
                    timed = (int) Math.max(1, Math.min(STEPS, (end - System.nanoTime()) / 2e6 / step));
                }
                ms.addValue(time(world, timed));
                rounds++;
                stats = world.stats();
                bytes = world.deviceMemory();
            }
        }
        Child.result(
                ms.getPercentile(50),
                before,
                timed,
                rounds,
                ready,
                (double) stats.contacts() / circles,
                stats.meanOverlap(),
                bytes > 0 ? (double) bytes / circles : "");
    }

    private Layout layout(int circles) {
        return packed ? Layout.packed(circles) : Layout.start(circles);
    }

    /** Milliseconds a step over some steps and the read-back at their end. */
    private static double time(Circles2D world, int steps) {
        long start = System.nanoTime();
        world.step(steps);
        world.snapshot();
        return (System.nanoTime() - start) / 1e6 / steps;
    }

    /** Compiled Java and kernels: two seconds of steps, or a quarter of the time, with fewer circles. */
    private void warmUp(Layout layout) {
        long now = System.nanoTime();
        long until = now + Math.min(2_000_000_000L, (end - now) / 4);
        try (Circles2D world = layout.world(builder())) {
            while (System.nanoTime() < until) {
                time(world, 1);
            }
        }
    }

    private Circles2D.Builder builder() {
        return Circles2D.builder()
                .device(device)
                .solver(Solver.SMALL_STEPS)
                .indexStrategy(IndexStrategy.grid())
                .substeps(substeps);
    }
}
