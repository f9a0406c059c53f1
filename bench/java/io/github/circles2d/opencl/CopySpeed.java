package io.github.circles2d.opencl;

import org.jocl.CL;
import org.jocl.Pointer;
import org.jocl.cl_command_queue;
import org.jocl.cl_context;
import org.jocl.cl_event;
import org.jocl.cl_mem;
import org.openjdk.jmh.util.ListStatistics;

/**
 * How fast a device copies from its memory to its memory, by its own clock, bytes read and written: what a kernel that only moves data can
 * hope for.
 *
 * @param bytes of the buffer that is copied
 * @param bytesPerSecond read and written
 */
record CopySpeed(long bytes, double bytesPerSecond) {
    /** Far more than any cache: what is still in one at the end of a copy has not been written. */
    private static final long BYTES = 1L << 30;

    private static final int WARM_UP = 2;
    private static final int COPIES = 10;

    /** Measures it on a queue with profiling; takes twice a sixteenth of the device's memory, or less. */
    static CopySpeed measure(OpenClDevice device, cl_context context, cl_command_queue queue) {
        long bytes = Long.highestOneBit(Math.min(BYTES, Math.min(device.maxBuffer, device.memory / 16)));
        cl_mem from = buffer(context, bytes);
        try {
            cl_mem to = buffer(context, bytes);
            try {
                // a page that was never written may be no page of its own
                Pointer pattern = Pointer.to(new int[] {1});
                Cl.check(
                        "clEnqueueFillBuffer",
                        CL.clEnqueueFillBuffer(queue, from, pattern, Integer.BYTES, 0, bytes, 0, null, null));
                ListStatistics nanoseconds = new ListStatistics();
                for (int copy = -WARM_UP; copy < COPIES; copy++) {
                    double taken = copy(queue, from, to, bytes);
                    if (copy >= 0) {
                        nanoseconds.addValue(taken);
                    }
                }
                return new CopySpeed(bytes, 2e9 * bytes / nanoseconds.getPercentile(50));
            } finally {
                CL.clReleaseMemObject(to);
            }
        } finally {
            CL.clReleaseMemObject(from);
        }
    }

    private static cl_mem buffer(cl_context context, long bytes) {
        int[] status = new int[1];
        cl_mem buffer = CL.clCreateBuffer(context, CL.CL_MEM_READ_WRITE, bytes, null, status);
        Cl.checkAllocation("clCreateBuffer", status[0], "a copy", bytes);
        return buffer;
    }

    private static long copy(cl_command_queue queue, cl_mem from, cl_mem to, long bytes) {
        cl_event event = new cl_event();
        Cl.check("clEnqueueCopyBuffer", CL.clEnqueueCopyBuffer(queue, from, to, 0, 0, bytes, 0, null, event));
        try {
            Cl.check("clFinish", CL.clFinish(queue));
            return Launches.time(event, CL.CL_PROFILING_COMMAND_END)
                    - Launches.time(event, CL.CL_PROFILING_COMMAND_START);
        } finally {
            CL.clReleaseEvent(event);
        }
    }
}
