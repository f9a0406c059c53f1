package io.github.circles2d.opencl;

import io.github.circles2d.CapacityException;
import java.util.ArrayDeque;
import java.util.Deque;
import org.jocl.CL;
import org.jocl.cl_command_queue;
import org.jocl.cl_context;
import org.jocl.cl_context_properties;

/**
 * A context and its queue on one device, and the memory taken from it. Owns both, and whatever is {@link #own given} to
 * it; releases in reverse order.
 */
final class Session implements AutoCloseable {
    final OpenClDevice device;
    final ClApi api;
    final cl_context context;
    final cl_command_queue queue;
    private final Deque<AutoCloseable> owned = new ArrayDeque<>();
    private long bytes;
    /** Kernels have a new range: some drivers compile them for it when they run. */
    boolean compiles;

    Session(OpenClDevice device) {
        this.device = device;
        api = device.api;
        cl_context_properties properties = new cl_context_properties();
        properties.addProperty(CL.CL_CONTEXT_PLATFORM, device.platformId);
        int[] status = new int[1];
        context = api.createContext(properties, device.id, status);
        Cl.check("clCreateContext", status[0]);
        cl_command_queue created = api.createCommandQueue(context, device.id, status);
        if (status[0] != CL.CL_SUCCESS) {
            Cl.checkRelease("clReleaseContext", api.releaseContext(context));
        }
        Cl.check("clCreateCommandQueue", status[0]);
        queue = created;
        SignalCanary.check();
        SignalCanary.handBack();
    }

    /** Takes over a resource: it is closed with the session unless it is closed before. */
    <T extends AutoCloseable> T own(T resource) {
        owned.push(resource);
        return resource;
    }

    /** Gives a resource back to the caller, who closes it. */
    void disown(AutoCloseable resource) {
        owned.remove(resource);
    }

    /**
     * Books memory before it is allocated: drivers hand out more than they have.
     *
     * @throws CapacityException if one buffer, or all of them together, are more than the device has
     */
    void book(String what, long more) {
        if (more > device.maxBuffer || bytes + more > device.memory) {
            throw new CapacityException(what + " takes " + more + " bytes; " + device.name() + " allows "
                    + device.maxBuffer + " in one buffer and " + device.memory + " in all, " + bytes
                    + " of which this world has taken");
        }
        bytes += more;
    }

    void unbook(long less) {
        bytes -= less;
    }

    /** Memory taken from the device, bytes. */
    long bytes() {
        return bytes;
    }

    void flush() {
        Cl.check("clFlush", api.flush(queue));
    }

    @Override
    public void close() {
        // nothing may still run on what is released now; a queue that failed has nothing running
        Cl.checkRelease("clFinish", api.finish(queue));
        while (!owned.isEmpty()) {
            try {
                owned.pop().close();
            } catch (Exception e) {
                throw new IllegalStateException("releases do not throw", e);
            }
        }
        Cl.checkRelease("clReleaseCommandQueue", api.releaseCommandQueue(queue));
        Cl.checkRelease("clReleaseContext", api.releaseContext(context));
    }
}
