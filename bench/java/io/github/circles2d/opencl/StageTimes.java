package io.github.circles2d.opencl;

import io.github.circles2d.Circles2D;
import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import io.github.circles2d.demo.Scene;
import io.github.circles2d.pipeline.Pipeline;
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
 * How long each kernel of a step takes on the device, by the device's own clock, for the thesis' scene after some steps.
 *
 * <pre>{@code
 * java -cp target/benchmarks.jar io.github.circles2d.opencl.StageTimes DEVICE CIRCLES STEPS_BEFORE STRATEGY STORE
 * }</pre>
 */
public final class StageTimes {
    private static final int STEPS = 200;

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

    /** Takes the five arguments of the class comment. */
    public static void main(String[] args) {
        String wanted = ComputeDevice.find(args[0]).orElseThrow().name();
        int circles = Integer.parseInt(args[1]);
        OpenClDevice device = OpenClDevices.list(profiling(JoclApi.load())).stream()
                .filter(d -> d.name().equals(wanted))
                .findFirst()
                .orElseThrow();
        WorldConfig config = new WorldConfig(
                1f / 60,
                Scene.THESIS.gravityX(),
                Scene.THESIS.gravityY(),
                Scene.THESIS.restitution(),
                0,
                0,
                1,
                1,
                IndexStrategy.named(args[3]),
                CollisionStore.valueOf(args[4]),
                Solver.IMPULSE,
                0,
                0,
                Tuning.SMALL_WORLD,
                0);
        FloatBuffer circle = direct(4 * circles);
        FloatBuffer velocities = direct(2 * circles);
        float maxRadius = 0;
        try (Circles2D world = Scene.THESIS.build(Circles2D.builder(), circles)) {
            world.step(Integer.parseInt(args[2]));
            var now = world.snapshot();
            for (int i = 0; i < circles; i++) {
                circle.put(4 * i, now.x(i)).put(4 * i + 1, now.y(i)).put(4 * i + 2, now.radius(i));
                circle.put(4 * i + 3, now.mass(i));
                velocities.put(2 * i, now.vx(i)).put(2 * i + 1, now.vy(i));
                maxRadius = Math.max(maxRadius, now.radius(i));
            }
        }
        Map<String, LongSummaryStatistics> times = new LinkedHashMap<>();
        long contacts;
        try (OpenClStages stages = new OpenClStages(device, config)) {
            stages.upload(circle, velocities, circles, maxRadius);
            Pipeline pipeline = new Pipeline(stages);
            pipeline.step();
            pipeline.await();
            for (int step = 0; step < STEPS; step++) {
                LAUNCHES.clear();
                pipeline.step();
                pipeline.await();
                for (Launch launch : LAUNCHES) {
                    long took = time(launch.event, CL.CL_PROFILING_COMMAND_END)
                            - time(launch.event, CL.CL_PROFILING_COMMAND_START);
                    times.computeIfAbsent(launch.kernel, k -> new LongSummaryStatistics())
                            .accept(took);
                    CL.clReleaseEvent(launch.event);
                }
            }
            contacts = pipeline.contacts();
        }
        System.out.printf(
                "%s, %d circles, after %s steps, %s, %s: %d contacts%n| kernel | launches a step | us a step |%n| --- | --- | --- |%n",
                device.name(), circles, args[2], args[3], args[4], contacts);
        times.forEach((kernel, t) -> System.out.printf(
                "| %s | %.0f | %.1f |%n", kernel, (double) t.getCount() / STEPS, t.getSum() / 1e3 / STEPS));
    }

    private static FloatBuffer direct(int floats) {
        return ByteBuffer.allocateDirect(4 * floats)
                .order(ByteOrder.nativeOrder())
                .asFloatBuffer();
    }
}
