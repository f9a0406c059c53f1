package io.github.circles2d.opencl;

import io.github.circles2d.Circles2D;
import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import io.github.circles2d.bench.Layout;
import io.github.circles2d.demo.Scene;
import io.github.circles2d.pipeline.Changes;
import io.github.circles2d.pipeline.DeviceState;
import io.github.circles2d.pipeline.Pipeline;
import io.github.circles2d.pipeline.Population;
import io.github.circles2d.pipeline.SmallPipeline;
import io.github.circles2d.pipeline.StepSums;
import io.github.circles2d.pipeline.Stepper;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.LinkedHashMap;
import java.util.LongSummaryStatistics;
import java.util.Map;

/**
 * How long each kernel of a step takes on the device, by the device's own clock, for a scene after some steps. Scene {@code rows} is {@link Layout#rows}. With more than 60 steps a second, those before are of 1/60 s
 * and have substeps of the same time, so that few substeps a step can be timed on a pile that more of them hold up.
 *
 * <p>Of small steps also how many bytes a launch reads and writes at least ({@link StageBytes}), and how fast that is, beside a copy from
 * the device's memory to its memory ({@link CopySpeed}).
 *
 * <pre>{@code
 * java -cp target/benchmarks.jar io.github.circles2d.opencl.StageTimes \
 *     DEVICE SCENE CIRCLES STEPS_BEFORE SOLVER SUBSTEPS STRATEGY STORE [WORK_GROUP [STEPS_A_SECOND]]
 * }</pre>
 */
public final class StageTimes {
    private static final int STEPS = 20;
    /** By the clock, without events: what a step takes goes up and down with how often contacts are listed. */
    private static final int UNWATCHED = 120;

    private StageTimes() {}

    /** Takes the arguments of the class comment. */
    public static void main(String[] args) {
        Launches launches = new Launches();
        String wanted = ComputeDevice.find(args[0]).orElseThrow().name();
        int circles = Integer.parseInt(args[2]);
        int before = Integer.parseInt(args[3]);
        OpenClDevice device = OpenClDevices.list(launches.watch(JoclApi.load())).stream()
                .filter(d -> d.name().equals(wanted))
                .findFirst()
                .orElseThrow();
        boolean rows = args[1].equals("rows");
        Scene scene = rows ? Layout.SCENE : Scene.named(args[1]);
        int substeps = Integer.parseInt(args[5]);
        int perSecond = args.length > 9 ? Integer.parseInt(args[9]) : 60;
        WorldConfig config = config(args, scene, perSecond, substeps);
        // on the way there at 60 steps a second, with the same substeps
        WorldConfig settling = config(args, scene, 60, substeps * perSecond / 60);
        FloatBuffer transforms = direct(4 * circles);
        FloatBuffer masses = direct(circles);
        FloatBuffer velocities = direct(2 * circles);
        Circles2D.Builder host = Circles2D.builder().device(ComputeDevice.host());
        try (Circles2D world = rows ? Layout.rows(circles).world(host) : scene.build(host, circles)) {
            var now = world.snapshot();
            for (int i = 0; i < circles; i++) {
                transforms.put(4 * i, now.x(i)).put(4 * i + 1, now.y(i)).put(4 * i + 2, now.radius(i));
                masses.put(i, now.mass(i));
                velocities.put(2 * i, now.vx(i)).put(2 * i + 1, now.vy(i));
            }
        }
        Changes changed = new Changes();
        for (int i = 0; i < circles; i++) {
            changed.add(i);
        }
        boolean small = config.solver() == Solver.SMALL_STEPS;
        try (DeviceState stages = small ? new OpenClSmallStages(device, config) : new OpenClStages(device, config)) {
            Stepper stepper = small
                    ? new SmallPipeline(settling, (OpenClSmallStages) stages)
                    : new Pipeline((OpenClStages) stages);
            stepper.upload(Population.of(transforms, masses, circles), velocities, changed);
            for (int step = 0; step < before; step++) {
                stepper.step();
                stepper.await();
                launches.take(null);
            }
            if (perSecond != 60) {
                stages.download(transforms, velocities);
                stepper = new SmallPipeline(config, (OpenClSmallStages) stages);
                stepper.upload(Population.of(transforms, masses, circles), velocities, changed);
            }
            Map<String, LongSummaryStatistics> times = new LinkedHashMap<>();
            long span = 0;
            long start = System.nanoTime();
            for (int step = 0; step < STEPS; step++) {
                stepper.step();
                stepper.await();
                span += launches.take(times);
            }
            double wall = (System.nanoTime() - start) / 1e3 / STEPS;
            StepSums sums = stages.sums();
            long contacts = stepper.contacts();
            launches.unwatch();
            start = System.nanoTime();
            for (int step = 0; step < UNWATCHED; step++) {
                stepper.step();
                stepper.await();
            }
            double unwatched = (System.nanoTime() - start) / 1e3 / UNWATCHED;
            System.out.printf(
                    "%n%s, %s, %d circles, after %d steps, %s, %s substeps, %s, %s%n"
                            + "contacts listed %d, touching %d, mean overlap %.4f, max %.3f, fastest %.3g%n"
                            + "| kernel | launches a step | us a step | us a launch | MB a launch | TB/s | of a copy |%n"
                            + "| --- | ---: | ---: | ---: | ---: | ---: | ---: |%n",
                    device.name(),
                    args[1],
                    circles,
                    before,
                    args[4],
                    args[5],
                    args[6],
                    args[7],
                    contacts,
                    sums.touching(),
                    sums.meanOverlap(),
                    sums.largestOverlap(),
                    sums.fastest());
            stages.download(transforms, velocities);
            double detections = count(times, "c2d_batch_order");
            StageBytes bytes = new StageBytes(
                    config,
                    transforms,
                    circles,
                    contacts,
                    detections > 0 ? count(times, "c2d_batch_colour") / detections : 0);
            CopySpeed copy = CopySpeed.measure(device, launches.context(), launches.queue());
            double busy = 0;
            double all = 0;
            for (var entry : times.entrySet()) {
                LongSummaryStatistics t = entry.getValue();
                busy += t.getSum() / 1e3 / STEPS;
                all += (double) t.getCount() / STEPS;
                System.out.printf(
                        "| %s | %.1f | %.1f | %.2f | %s |%n",
                        entry.getKey(),
                        (double) t.getCount() / STEPS,
                        t.getSum() / 1e3 / STEPS,
                        t.getAverage() / 1e3,
                        speed(small ? bytes.of(entry.getKey()) : 0, t.getAverage(), copy));
            }
            System.out.printf(
                    "| all | %.0f | %.1f | | | | |%n| from first to last | | %.1f | | | | |%n"
                            + "| wall clock, with events | | %.1f | | | | |%n"
                            + "| wall clock, without | | %.1f | | | | |%n%n"
                            + "copy of %d MiB: %.3g TB/s%n",
                    all, busy, span / 1e3 / STEPS, wall, unwatched, copy.bytes() >> 20, copy.bytesPerSecond() / 1e12);
        }
    }

    private static double count(Map<String, LongSummaryStatistics> times, String kernel) {
        return times.containsKey(kernel) ? times.get(kernel).getCount() : 0;
    }

    /** The last three columns of a kernel; none without bytes. */
    private static String speed(double bytes, double nanoseconds, CopySpeed copy) {
        double perSecond = bytes / nanoseconds * 1e9;
        return bytes == 0
                ? "| |"
                : String.format(
                        "%.3g | %.3g | %.0f %%",
                        bytes / 1e6, perSecond / 1e12, 100 * perSecond / copy.bytesPerSecond());
    }

    private static WorldConfig config(String[] args, Scene scene, int perSecond, int substeps) {
        return new WorldConfig(
                1f / perSecond,
                scene.gravityX(),
                scene.gravityY(),
                scene.restitution(),
                0,
                0,
                1,
                1,
                IndexStrategy.named(args[6]),
                CollisionStore.valueOf(args[7]),
                Solver.valueOf(args[4]),
                args.length > 8 ? Integer.parseInt(args[8]) : 0,
                0,
                Tuning.SMALL_WORLD,
                Tuning.ALONE_CIRCLES,
                substeps);
    }

    private static FloatBuffer direct(int floats) {
        return ByteBuffer.allocateDirect(4 * floats)
                .order(ByteOrder.nativeOrder())
                .asFloatBuffer();
    }
}
