package io.github.circles2d.opencl;

import java.nio.ByteBuffer;
import org.jocl.CL;
import org.jocl.CLException;
import org.jocl.Pointer;
import org.jocl.cl_buffer_region;
import org.jocl.cl_command_queue;
import org.jocl.cl_context;
import org.jocl.cl_context_properties;
import org.jocl.cl_device_id;
import org.jocl.cl_kernel;
import org.jocl.cl_mem;
import org.jocl.cl_platform_id;
import org.jocl.cl_program;

/**
 * The real OpenCL, through JOCL. JOCL's exceptions are off by default but belong to the whole process: where the
 * application has turned them on they become statuses again here.
 */
final class JoclApi implements ClApi {
    /** JOCL keeps its contexts in a map that two threads may not change at a time: the JVM would crash. */
    private static final Object CONTEXTS = new Object();

    private JoclApi() {}

    /**
     * Loads JOCL and the OpenCL loader of the machine.
     *
     * @throws LinkageError if there is none; a second try fails likewise
     */
    static ClApi load() {
        // without it JOCL runs whatever library of its name lies in the temporary folder
        if (System.getProperty("uniqueLibraryNames") == null) {
            System.setProperty("uniqueLibraryNames", "true");
        }
        CL.stringFor_errorCode(CL.CL_SUCCESS);
        return new JoclApi();
    }

    private static <T> T failed(CLException e, int[] status) {
        status[0] = e.getStatus();
        return null;
    }

    @Override
    public int getPlatformIDs(int room, cl_platform_id[] platforms, int[] count) {
        try {
            return CL.clGetPlatformIDs(room, platforms, count);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int getPlatformInfo(cl_platform_id platform, int name, long size, Pointer value, long[] needed) {
        try {
            return CL.clGetPlatformInfo(platform, name, size, value, needed);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int getDeviceIDs(cl_platform_id platform, long type, int room, cl_device_id[] devices, int[] count) {
        try {
            return CL.clGetDeviceIDs(platform, type, room, devices, count);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int getDeviceInfo(cl_device_id device, int name, long size, Pointer value, long[] needed) {
        try {
            return CL.clGetDeviceInfo(device, name, size, value, needed);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public cl_context createContext(cl_context_properties properties, cl_device_id device, int[] status) {
        try {
            synchronized (CONTEXTS) {
                return CL.clCreateContext(properties, 1, new cl_device_id[] {device}, null, null, status);
            }
        } catch (CLException e) {
            return failed(e, status);
        }
    }

    @Override
    @SuppressWarnings("deprecation") // its successor is missing on OpenCL 1.2 drivers
    public cl_command_queue createCommandQueue(cl_context context, cl_device_id device, int[] status) {
        try {
            return CL.clCreateCommandQueue(context, device, 0, status);
        } catch (CLException e) {
            return failed(e, status);
        }
    }

    @Override
    public cl_mem createBuffer(cl_context context, long flags, long bytes, int[] status) {
        try {
            return CL.clCreateBuffer(context, flags, bytes, null, status);
        } catch (CLException e) {
            return failed(e, status);
        }
    }

    @Override
    public cl_mem createSubBuffer(cl_mem buffer, long flags, long offset, long bytes, int[] status) {
        try {
            cl_buffer_region region = new cl_buffer_region(offset, bytes);
            return CL.clCreateSubBuffer(buffer, flags, CL.CL_BUFFER_CREATE_TYPE_REGION, region, status);
        } catch (CLException e) {
            return failed(e, status);
        }
    }

    @Override
    public cl_program createProgramWithSource(cl_context context, String[] sources, int[] status) {
        try {
            return CL.clCreateProgramWithSource(context, sources.length, sources, null, status);
        } catch (CLException e) {
            return failed(e, status);
        }
    }

    @Override
    public int buildProgram(cl_program program, cl_device_id device, String options) {
        try {
            return CL.clBuildProgram(program, 1, new cl_device_id[] {device}, options, null, null);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int getProgramBuildInfo(
            cl_program program, cl_device_id device, int name, long size, Pointer value, long[] needed) {
        try {
            return CL.clGetProgramBuildInfo(program, device, name, size, value, needed);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public cl_kernel createKernel(cl_program program, String name, int[] status) {
        try {
            return CL.clCreateKernel(program, name, status);
        } catch (CLException e) {
            return failed(e, status);
        }
    }

    @Override
    public int getKernelWorkGroupInfo(cl_kernel kernel, cl_device_id device, int name, long size, Pointer value) {
        try {
            return CL.clGetKernelWorkGroupInfo(kernel, device, name, size, value, null);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int setKernelArg(cl_kernel kernel, int index, long size, Pointer value) {
        try {
            return CL.clSetKernelArg(kernel, index, size, value);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int enqueueNDRangeKernel(
            cl_command_queue queue, cl_kernel kernel, long[] offset, long[] global, long[] local) {
        try {
            return CL.clEnqueueNDRangeKernel(queue, kernel, 1, offset, global, local, 0, null, null);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int enqueueReadBuffer(cl_command_queue queue, cl_mem buffer, long offset, long bytes, Pointer to) {
        try {
            return CL.clEnqueueReadBuffer(queue, buffer, true, offset, bytes, to, 0, null, null);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int enqueueWriteBuffer(cl_command_queue queue, cl_mem buffer, long offset, long bytes, Pointer from) {
        try {
            return CL.clEnqueueWriteBuffer(queue, buffer, true, offset, bytes, from, 0, null, null);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int enqueueCopyBuffer(cl_command_queue queue, cl_mem from, cl_mem to, long fromAt, long toAt, long bytes) {
        try {
            return CL.clEnqueueCopyBuffer(queue, from, to, fromAt, toAt, bytes, 0, null, null);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int enqueueFillBuffer(
            cl_command_queue queue, cl_mem buffer, Pointer pattern, long patternBytes, long offset, long bytes) {
        try {
            return CL.clEnqueueFillBuffer(queue, buffer, pattern, patternBytes, offset, bytes, 0, null, null);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public ByteBuffer enqueueMapBuffer(cl_command_queue queue, cl_mem buffer, long flags, long bytes, int[] status) {
        try {
            return CL.clEnqueueMapBuffer(queue, buffer, true, flags, 0, bytes, 0, null, null, status);
        } catch (CLException e) {
            return failed(e, status);
        }
    }

    @Override
    public int enqueueUnmapMemObject(cl_command_queue queue, cl_mem buffer, ByteBuffer mapped) {
        try {
            return CL.clEnqueueUnmapMemObject(queue, buffer, mapped, 0, null, null);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int flush(cl_command_queue queue) {
        try {
            return CL.clFlush(queue);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int finish(cl_command_queue queue) {
        try {
            return CL.clFinish(queue);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int releaseKernel(cl_kernel kernel) {
        try {
            return CL.clReleaseKernel(kernel);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int releaseProgram(cl_program program) {
        try {
            return CL.clReleaseProgram(program);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int releaseMemObject(cl_mem buffer) {
        try {
            return CL.clReleaseMemObject(buffer);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int releaseCommandQueue(cl_command_queue queue) {
        try {
            return CL.clReleaseCommandQueue(queue);
        } catch (CLException e) {
            return e.getStatus();
        }
    }

    @Override
    public int releaseContext(cl_context context) {
        try {
            synchronized (CONTEXTS) {
                return CL.clReleaseContext(context);
            }
        } catch (CLException e) {
            return e.getStatus();
        }
    }
}
