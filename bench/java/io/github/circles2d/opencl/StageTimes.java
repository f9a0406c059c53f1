package io.github.circles2d.opencl;

import io.github.circles2d.Circles2D;
import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import io.github.circles2d.bench.Packed;
import io.github.circles2d.demo.Scene;
import io.github.circles2d.pipeline.DeviceState;
import io.github.circles2d.pipeline.Pipeline;
import io.github.circles2d.pipeline.SmallPipeline;
import io.github.circles2d.pipeline.StepSums;
import io.github.circles2d.pipeline.Stepper;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;
import java.lang.reflect.Proxy;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.LongSummaryStatistics;
import java.util.Map;
import org.jocl.CL;
import org.jocl.Pointer;
import org.jocl.Sizeof;
import org.jocl.cl_command_queue;
import org.jocl.cl_context;
import org.jocl.cl_device_id;
import org.jocl.cl_event;
import org.jocl.cl_kernel;

/**
 * How long each kernel of a step takes on the device, by the device's own clock, for a scene after some steps. Scene {@code
 * packed} is the circles of {@code pile} laid out as they lie in a pile. With more than 60 steps a second, those before are of 1/60 s
 * and have substeps of the same time, so that few substeps a step can be timed on a pile that more of them hold up.
 *
 * <pre>{@code
 * java -cp target/benchmarks.jar io.github.circles2d.opencl.StageTimes \
 *     DEVICE SCENE CIRCLES STEPS_BEFORE SOLVER SUBSTEPS STRATEGY STORE [WORK_GROUP [STEPS_A_SECOND]]
 * }</pre>
 */
public final class StageTimes {
    private static final int STEPS = 20;

    private record Launch(String kernel, cl_event event) {}

    private static final Map<cl_kernel, String> NAMES = new HashMap<>();
    private static final List<Launch> LAUNCHES = new ArrayList<>();

    private StageTimes() {}

    @SuppressWarnings("deprecation")
    private static ClApi profiling(ClApi api) {
        return (ClApi) Proxy.newProxyInstance(
                ClApi.class.getClassLoader(), new Class<?>[] {ClApi.class}, (proxy, method, args) -> {
                    if (method.getName().equals("createCommandQueue")) {
                        return CL.clCreateCommandQueue(
                                (cl_context) args[0], (cl_device_id) args[1], CL.CL_QUEUE_PROFILING_ENABLE, (int[])
                                        args[2]);
                    }
                    if (method.getName().equals("enqueueNDRangeKernel")) {
                        cl_event event = new cl_event();
                        LAUNCHES.add(new Launch(NAMES.get(args[1]), event));
                        return CL.clEnqueueNDRangeKernel(
                                (cl_command_queue) args[0],
                                (cl_kernel) args[1],
                                1,
                                (long[]) args[2],
                                (long[]) args[3],
                                (long[]) args[4],
                                0,
                                null,
                                event);
                    }
                    Object result = method.invoke(api, args);
                    if (method.getName().equals("createKernel")) {
                        NAMES.put((cl_kernel) result, (String) args[1]);
                    }
                    return result;
                });
    }

    private static long time(cl_event event, int what) {
        long[] value = new long[1];
        Cl.check(
                "clGetEventProfilingInfo",
                CL.clGetEventProfilingInfo(event, what, Sizeof.cl_ulong, Pointer.to(value), null));
        return value[0];
    }

    /** Takes the arguments of the class comment. */
    public static void main(String[] args) {
        String wanted = ComputeDevice.find(args[0]).orElseThrow().name();
        int circles = Integer.parseInt(args[2]);
        int before = Integer.parseInt(args[3]);
        OpenClDevice device = OpenClDevices.list(profiling(JoclApi.load())).stream()
                .filter(d -> d.name().equals(wanted))
                .findFirst()
                .orElseThrow();
        Scene scene = args[1].equals("packed") ? Packed.SCENE : Scene.named(args[1]);
        int substeps = Integer.parseInt(args[5]);
        int perSecond = args.length > 9 ? Integer.parseInt(args[9]) : 60;
        WorldConfig config = config(args, scene, perSecond, substeps);
        // on the way there at 60 steps a second, with the same substeps
        WorldConfig settling = config(args, scene, 60, substeps * perSecond / 60);
        FloatBuffer circle = direct(4 * circles);
        FloatBuffer velocities = direct(2 * circles);
        float maxRadius = 0;
        try (Circles2D world = scene.build(Circles2D.builder().device(ComputeDevice.host()), circles)) {
            var now = world.snapshot();
            for (int i = 0; i < circles; i++) {
                circle.put(4 * i, now.x(i)).put(4 * i + 1, now.y(i)).put(4 * i + 2, now.radius(i));
                circle.put(4 * i + 3, now.mass(i));
                velocities.put(2 * i, now.vx(i)).put(2 * i + 1, now.vy(i));
                maxRadius = Math.max(maxRadius, now.radius(i));
            }
        }
        boolean small = config.solver() == Solver.SMALL_STEPS;
        try (DeviceState stages = small ? new OpenClSmallStages(device, config) : new OpenClStages(device, config)) {
            Stepper stepper =
                    small ? new SmallPipeline(config, (OpenClSmallStages) stages) : new Pipeline((OpenClStages) stages);
            stepper.upload(circle, velocities, circles, maxRadius);
            for (int step = 0; step < before; step++) {
                stepper.step();
                stepper.await();
                take(null);
            }
            if (perSecond != 60) {
                stages.download(circle, velocities);
                stepper = new SmallPipeline(config, (OpenClSmallStages) stages);
                stepper.upload(circle, velocities, circles, maxRadius);
            }
            Map<String, LongSummaryStatistics> times = new LinkedHashMap<>();
            long span = 0;
            long start = System.nanoTime();
            for (int step = 0; step < STEPS; step++) {
                stepper.step();
                stepper.await();
                span += take(times);
            }
            double wall = (System.nanoTime() - start) / 1e3 / STEPS;
            StepSums sums = stages.sums();
            System.out.printf(
                    "%n%s, %s, %d circles, after %d steps, %s, %s substeps, %s, %s%n"
                            + "contacts listed %d, touching %d, mean overlap %.4f, max %.3f, fastest %.3g%n"
                            + "| kernel | launches a step | us a step | us a launch |%n| --- | ---: | ---: | ---: |%n",
                    device.name(),
                    args[1],
                    circles,
                    before,
                    args[4],
                    args[5],
                    args[6],
                    args[7],
                    stepper.contacts(),
                    sums.touching(),
                    sums.meanOverlap(),
                    sums.largestOverlap(),
                    sums.fastest());
            double busy = 0;
            double launches = 0;
            for (var entry : times.entrySet()) {
                LongSummaryStatistics t = entry.getValue();
                busy += t.getSum() / 1e3 / STEPS;
                launches += (double) t.getCount() / STEPS;
                System.out.printf(
                        "| %s | %.1f | %.1f | %.2f |%n",
                        entry.getKey(), (double) t.getCount() / STEPS, t.getSum() / 1e3 / STEPS, t.getAverage() / 1e3);
            }
            System.out.printf(
                    "| all | %.0f | %.1f | |%n| from first to last | | %.1f | |%n| wall clock, with events | | %.1f | |%n",
                    launches, busy, span / 1e3 / STEPS, wall);
        }
    }

    /** Books the launches since the last call and forgets them; the time from the start of the first to the end of the last. */
    private static long take(Map<String, LongSummaryStatistics> times) {
        long first = Long.MAX_VALUE;
        long last = 0;
        for (Launch launch : LAUNCHES) {
            if (times != null) {
                long start = time(launch.event, CL.CL_PROFILING_COMMAND_START);
                long end = time(launch.event, CL.CL_PROFILING_COMMAND_END);
                first = Math.min(first, start);
                last = Math.max(last, end);
                times.computeIfAbsent(launch.kernel, k -> new LongSummaryStatistics())
                        .accept(end - start);
            }
            CL.clReleaseEvent(launch.event);
        }
        LAUNCHES.clear();
        return last - Math.min(first, last);
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
                substeps);
    }

    private static FloatBuffer direct(int floats) {
        return ByteBuffer.allocateDirect(4 * floats)
                .order(ByteOrder.nativeOrder())
                .asFloatBuffer();
    }
}
