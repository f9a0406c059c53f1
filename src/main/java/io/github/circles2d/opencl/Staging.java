package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Tuning;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import org.jocl.CL;
import org.jocl.Pointer;
import org.jocl.cl_mem;

/**
 * Memory of the host through which the state is written and read back. Where the driver can, it is pinned: a GPU then writes into it by
 * itself, while for other memory the driver copies piece by piece. It is none of the device's memory. Nobody outside may see it, for it is gone when
 * the session is closed.
 */
final class Staging implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger("io.github.circles2d");
    private static final ByteBuffer NONE = ByteBuffer.allocateDirect(0);

    private final Session session;
    /** Null where what there is is plain memory. */
    private cl_mem memory;

    private ByteBuffer bytes = NONE;
    private FloatBuffer floats;
    private Pointer pointer;

    /** None yet; the session closes it. */
    Staging(Session session) {
        this.session = session;
        session.own(this);
    }

    /** Makes sure that there are at least {@code wanted} bytes; what was there is lost. */
    void ensure(int wanted) {
        if (bytes.capacity() >= wanted) {
            return;
        }
        // a world may grow a little in each frame
        int room = Math.max(wanted, (int) Math.min(Tuning.STAGING_BYTES, bytes.capacity() * Tuning.GROWTH));
        release();
        ByteBuffer pinned = pin(room);
        bytes = (pinned != null ? pinned : ByteBuffer.allocateDirect(room)).order(ByteOrder.nativeOrder());
        floats = bytes.asFloatBuffer();
        pointer = Pointer.to(bytes);
    }

    /** Pinned memory, mapped for good, or null. */
    private ByteBuffer pin(int wanted) {
        if (!session.device.maps) {
            return null;
        }
        int[] status = new int[1];
        long flags = CL.CL_MEM_READ_WRITE | CL.CL_MEM_ALLOC_HOST_PTR;
        cl_mem created = session.api.createBuffer(session.context, flags, wanted, status);
        if (status[0] != CL.CL_SUCCESS) {
            return without("clCreateBuffer gives " + CL.stringFor_errorCode(status[0]));
        }
        flags = CL.CL_MAP_READ | CL.CL_MAP_WRITE;
        ByteBuffer mapped = session.api.enqueueMapBuffer(session.queue, created, flags, wanted, status);
        if (status[0] != CL.CL_SUCCESS) {
            Cl.checkRelease("clReleaseMemObject(staging)", session.api.releaseMemObject(created));
            return without("clEnqueueMapBuffer gives " + CL.stringFor_errorCode(status[0]));
        }
        memory = created;
        return mapped;
    }

    private static ByteBuffer without(String why) {
        LOG.log(System.Logger.Level.WARNING, "no pinned memory, copies of circles take longer: {0}", why);
        return null;
    }

    /** How much there is, bytes. */
    int room() {
        return bytes.capacity();
    }

    /** What there is, in native order. */
    ByteBuffer bytes() {
        return bytes;
    }

    /** The same as floats. */
    FloatBuffer floats() {
        return floats;
    }

    /** The same for OpenCL. */
    Pointer pointer() {
        return pointer;
    }

    private void release() {
        ByteBuffer old = bytes;
        bytes = NONE;
        floats = null;
        pointer = null;
        if (memory != null) {
            Cl.checkRelease(
                    "clEnqueueUnmapMemObject(staging)", session.api.enqueueUnmapMemObject(session.queue, memory, old));
            Cl.checkRelease("clFinish", session.api.finish(session.queue));
            Cl.checkRelease("clReleaseMemObject(staging)", session.api.releaseMemObject(memory));
            memory = null;
        }
    }

    @Override
    public void close() {
        session.disown(this);
        release();
    }
}
