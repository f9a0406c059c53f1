package io.github.circles2d.opencl;

import io.github.circles2d.CapacityException;
import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.Consumer;
import org.jocl.CL;
import org.jocl.Pointer;
import org.jocl.cl_mem;

/** One buffer of the device: owns its {@code cl_mem}. Named as the kernels name it. */
final class DeviceBuffer implements AutoCloseable {
    private final Session session;
    private final String name;
    private cl_mem memory;
    private long bytes;

    /** An empty buffer; the session closes it. */
    DeviceBuffer(Session session, String name) {
        this.session = session;
        this.name = name;
        session.own(this);
    }

    /** Makes sure that there are at least {@code wanted} bytes; what was in the buffer may be lost. */
    void ensure(long wanted) {
        long needed = room(wanted);
        if (bytes >= needed) {
            return;
        }
        release();
        session.book(name, needed);
        int[] status = new int[1];
        cl_mem created = session.api.createBuffer(session.context, CL.CL_MEM_READ_WRITE, needed, status);
        if (status[0] != CL.CL_SUCCESS) {
            session.unbook(needed);
        }
        Cl.checkAllocation("clCreateBuffer", status[0], name, needed);
        memory = created;
        bytes = needed;
    }

    /** Whole ints, and never nothing, which drivers refuse. */
    private static long room(long wanted) {
        return Math.max(wanted + 3 & ~3, 16);
    }

    /** Copies bytes of another buffer; there may be none. */
    void copy(DeviceBuffer from, long at, long to, long count) {
        copy(from.memory, at, to, count);
    }

    private void copy(cl_mem from, long at, long to, long count) {
        if (count > 0) {
            Cl.check("clEnqueueCopyBuffer", session.api.enqueueCopyBuffer(session.queue, from, memory, at, to, count));
        }
    }

    /** Sets every int of {@code count} bytes, whole ints, to the one at {@code value}; there may be none. */
    void fill(long at, long count, Pointer value) {
        if (count > 0) {
            Cl.check("clEnqueueFillBuffer", session.api.enqueueFillBuffer(session.queue, memory, value, 4, at, count));
        }
    }

    /** Makes this buffer a part of another one, which must have been {@link #ensure ensured} and stays its owner. */
    void become(DeviceBuffer whole, long offset, long count) {
        release();
        int[] status = new int[1];
        cl_mem created =
                session.api.createSubBuffer(whole.memory, CL.CL_MEM_READ_WRITE, offset, Math.max(count, 16), status);
        Cl.checkAllocation("clCreateSubBuffer", status[0], name, count);
        memory = created;
    }

    cl_mem memory() {
        return memory;
    }

    /** Writes the first {@code count} bytes of a direct buffer. Waits. */
    void write(Buffer from, long count) {
        if (count > 0) {
            write(Pointer.to(from), count);
        }
    }

    /** As {@link #write(Buffer, long)}, from a pointer that the caller keeps: allocates nothing. */
    void write(Pointer from, long count) {
        write(0, from, count);
    }

    /** The same to {@code offset} and on. */
    void write(long offset, Pointer from, long count) {
        Cl.check("clEnqueueWriteBuffer", session.api.enqueueWriteBuffer(session.queue, memory, offset, count, from));
    }

    /** Reads {@code count} bytes from {@code offset} on into a direct buffer. Waits. */
    void read(long offset, Buffer to, long count) {
        if (count > 0) {
            read(offset, Pointer.to(to), count);
        }
    }

    /** As {@link #read(long, Buffer, long)}, into a pointer that the caller keeps: allocates nothing. */
    void read(long offset, Pointer to, long count) {
        Cl.check("clEnqueueReadBuffer", session.api.enqueueReadBuffer(session.queue, memory, offset, count, to));
    }

    /**
     * Writes the first {@code count} bytes, which {@code filler} puts into a buffer of native order. Waits.
     *
     * @throws CapacityException if Java has no room for such a buffer
     */
    void fill(long count, Consumer<ByteBuffer> filler) {
        ByteBuffer from;
        try {
            from = ByteBuffer.allocateDirect(Math.toIntExact(count)).order(ByteOrder.nativeOrder());
        } catch (OutOfMemoryError e) {
            throw new CapacityException("no direct memory for " + name + ", " + count
                    + " bytes (raise -XX:MaxDirectMemorySize): " + e.getMessage());
        }
        filler.accept(from);
        write(from.clear(), count);
    }

    private void release() {
        if (memory != null) {
            Cl.checkRelease("clReleaseMemObject(" + name + ")", session.api.releaseMemObject(memory));
            memory = null;
            session.unbook(bytes);
            bytes = 0;
        }
    }

    @Override
    public void close() {
        session.disown(this);
        release();
    }
}
