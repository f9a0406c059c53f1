package io.github.circles2d.opencl;

import io.github.circles2d.CapacityException;
import io.github.circles2d.pipeline.Status;
import io.github.circles2d.pipeline.Tuning;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import org.jocl.Pointer;

/**
 * The contacts on the device: the buffers {@code found}, {@code byCell}, {@code contact}, {@code cellStart} and {@code status} of
 * the kernels.
 */
final class Contacts {
    /** A contact: the numbers of its circles and its translation vector, an int4. */
    static final long BYTES = 16;

    private static final int STATUS_BYTES = 12;

    /** As detect found them. */
    final DeviceBuffer found;
    /** Sorted by cell. */
    final DeviceBuffer byCell;
    /** Sorted by cell and numbers. */
    final DeviceBuffer contact;
    /** The first contact of each cell. */
    final DeviceBuffer cellStart;

    final DeviceBuffer status;
    private final IntBuffer statusCopy = ByteBuffer.allocateDirect(STATUS_BYTES)
            .order(ByteOrder.nativeOrder())
            .asIntBuffer();
    private final Pointer statusPointer = Pointer.to(statusCopy);
    private int updatesSeen;
    private int capacity;

    Contacts(Session session) {
        found = new DeviceBuffer(session, "found");
        byCell = new DeviceBuffer(session, "byCell");
        contact = new DeviceBuffer(session, "contact");
        cellStart = new DeviceBuffer(session, "cellStart");
        status = new DeviceBuffer(session, "status");
        status.ensure(STATUS_BYTES);
        clearStatus();
    }

    int capacity() {
        return capacity;
    }

    /** Makes room for at least so many contacts; those there are may be lost. */
    void ensure(long wanted) {
        if (wanted <= capacity) {
            return;
        }
        if (wanted > Integer.MAX_VALUE) {
            throw new CapacityException("a step found " + wanted + " contacts; a world has room for 2^31 - 1");
        }
        capacity = 0;
        found.ensure(BYTES * wanted);
        byCell.ensure(BYTES * wanted);
        contact.ensure(BYTES * wanted);
        capacity = (int) wanted;
    }

    /** What the device says of itself. Waits for all that is queued. */
    Status await() {
        status.read(0, statusPointer, STATUS_BYTES);
        int updates = statusCopy.get(2) - updatesSeen;
        updatesSeen = statusCopy.get(2);
        return new Status(Integer.toUnsignedLong(statusCopy.get(0)), statusCopy.get(1) != 0, updates);
    }

    void makeRoom(long contacts) {
        ensure((long) Math.min(Integer.MAX_VALUE, Math.max(contacts, contacts * Tuning.GROWTH)));
        clearStatus();
    }

    private void clearStatus() {
        for (int i = 0; i < STATUS_BYTES / 4; i++) {
            statusCopy.put(i, 0);
        }
        updatesSeen = 0;
        status.write(statusCopy, STATUS_BYTES);
    }
}
