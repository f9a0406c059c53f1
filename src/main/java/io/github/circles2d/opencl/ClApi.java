package io.github.circles2d.opencl;

import java.nio.ByteBuffer;
import org.jocl.Pointer;
import org.jocl.cl_command_queue;
import org.jocl.cl_context;
import org.jocl.cl_context_properties;
import org.jocl.cl_device_id;
import org.jocl.cl_kernel;
import org.jocl.cl_mem;
import org.jocl.cl_platform_id;
import org.jocl.cl_program;

/**
 * The OpenCL functions that the library uses, and no others: each method is the function of its name, with a status as
 * its result or in {@code status[0]}. An interface, so that a test can make any call fail. Nothing here throws.
 */
public interface ClApi {
    int getPlatformIDs(int room, cl_platform_id[] platforms, int[] count);

    int getPlatformInfo(cl_platform_id platform, int name, long size, Pointer value, long[] needed);

    int getDeviceIDs(cl_platform_id platform, long type, int room, cl_device_id[] devices, int[] count);

    int getDeviceInfo(cl_device_id device, int name, long size, Pointer value, long[] needed);

    cl_context createContext(cl_context_properties properties, cl_device_id device, int[] status);

    cl_command_queue createCommandQueue(cl_context context, cl_device_id device, int[] status);

    cl_mem createBuffer(cl_context context, long flags, long bytes, int[] status);

    /** A part of a buffer. */
    cl_mem createSubBuffer(cl_mem buffer, long flags, long offset, long bytes, int[] status);

    cl_program createProgramWithSource(cl_context context, String[] sources, int[] status);

    int buildProgram(cl_program program, cl_device_id device, String options);

    int getProgramBuildInfo(cl_program program, cl_device_id device, int name, long size, Pointer value, long[] needed);

    cl_kernel createKernel(cl_program program, String name, int[] status);

    int getKernelWorkGroupInfo(cl_kernel kernel, cl_device_id device, int name, long size, Pointer value);

    int setKernelArg(cl_kernel kernel, int index, long size, Pointer value);

    int enqueueNDRangeKernel(cl_command_queue queue, cl_kernel kernel, long[] offset, long[] global, long[] local);

    /** Blocking. */
    int enqueueReadBuffer(cl_command_queue queue, cl_mem buffer, long offset, long bytes, Pointer to);

    /** Blocking. */
    int enqueueWriteBuffer(cl_command_queue queue, cl_mem buffer, long offset, long bytes, Pointer from);

    int enqueueCopyBuffer(cl_command_queue queue, cl_mem from, cl_mem to, long fromAt, long toAt, long bytes);

    /** Writes a pattern over and over again. */
    int enqueueFillBuffer(
            cl_command_queue queue, cl_mem buffer, Pointer pattern, long patternBytes, long offset, long bytes);

    /** A buffer from its beginning, as memory of the host. Blocking. */
    ByteBuffer enqueueMapBuffer(cl_command_queue queue, cl_mem buffer, long flags, long bytes, int[] status);

    int enqueueUnmapMemObject(cl_command_queue queue, cl_mem buffer, ByteBuffer mapped);

    int flush(cl_command_queue queue);

    int finish(cl_command_queue queue);

    int releaseKernel(cl_kernel kernel);

    int releaseProgram(cl_program program);

    int releaseMemObject(cl_mem buffer);

    int releaseCommandQueue(cl_command_queue queue);

    int releaseContext(cl_context context);
}
