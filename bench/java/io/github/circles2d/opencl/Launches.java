package io.github.circles2d.opencl;

import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.HashMap;
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

/** Every launch of a kernel through an {@link ClApi}, by the device's own clock; and the queue that they went to. */
final class Launches {
    /** What launches of c2d_solve for the first tiling are called. */
    static final String FIRST_TILING = "c2d_solve, first tiling";

    private record Launch(String kernel, cl_event event) {}

    private final Map<cl_kernel, String> names = new HashMap<>();
    private final List<Launch> launches = new ArrayList<>();
    private cl_context context;
    private cl_command_queue queue;
    private boolean watched = true;

    /** The same calls, with queues that keep times and an event for each launch. */
    @SuppressWarnings("deprecation")
    ClApi watch(ClApi api) {
        return (ClApi) Proxy.newProxyInstance(
                ClApi.class.getClassLoader(), new Class<?>[] {ClApi.class}, (proxy, method, args) -> {
                    if (method.getName().equals("createCommandQueue")) {
                        context = (cl_context) args[0];
                        queue = CL.clCreateCommandQueue(
                                context, (cl_device_id) args[1], CL.CL_QUEUE_PROFILING_ENABLE, (int[]) args[2]);
                        return queue;
                    }
                    if (method.getName().equals("enqueueNDRangeKernel") && watched) {
                        cl_event event = new cl_event();
                        launches.add(new Launch(names.get(args[1]), event));
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
                    if (method.getName().equals("setKernelArg") && args[3] == null && (long) args[2] > 64) {
                        // the first tiling alone has local memory
                        names.replace((cl_kernel) args[0], "c2d_solve", FIRST_TILING);
                    }
                    if (method.getName().equals("createKernel")) {
                        names.put((cl_kernel) result, (String) args[1]);
                    }
                    return result;
                });
    }

    /** A time of an event that is over, nanoseconds. */
    static long time(cl_event event, int what) {
        long[] value = new long[1];
        Cl.check(
                "clGetEventProfilingInfo",
                CL.clGetEventProfilingInfo(event, what, Sizeof.cl_ulong, Pointer.to(value), null));
        return value[0];
    }

    /** No events from here on: they make launches dearer. */
    void unwatch() {
        watched = false;
    }

    cl_context context() {
        return context;
    }

    /** The last that was made. */
    cl_command_queue queue() {
        return queue;
    }

    /** Books the launches since the last call and forgets them; the time from the start of the first to the end of the last. */
    long take(Map<String, LongSummaryStatistics> times) {
        long first = Long.MAX_VALUE;
        long last = 0;
        for (Launch launch : launches) {
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
        launches.clear();
        return last - Math.min(first, last);
    }
}
