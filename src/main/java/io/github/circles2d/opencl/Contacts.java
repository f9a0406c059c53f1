package io.github.circles2d.opencl;

import io.github.circles2d.CapacityException;
import io.github.circles2d.pipeline.Tuning;

/**
 * The contacts on the device: the buffers {@code found}, {@code byCell}, {@code contact} and {@code cellStart} of the
 * kernels.
 */
final class Contacts {
    /** A contact as it is found: the numbers of its circles and its translation vector, an int4. */
    static final long BYTES = 16;

    /** As detect found them. */
    final DeviceBuffer found;
    /** Sorted by cell. */
    final DeviceBuffer byCell;
    /** Sorted by cell and numbers, and ready to be resolved: an int8 a contact. */
    final DeviceBuffer contact;
    /** The first contact of each cell. */
    final DeviceBuffer cellStart;

    private int capacity;

    Contacts(Session session) {
        found = new DeviceBuffer(session, "found");
        byCell = new DeviceBuffer(session, "byCell");
        contact = new DeviceBuffer(session, "contact");
        cellStart = new DeviceBuffer(session, "cellStart");
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
        contact.ensure(2 * BYTES * wanted);
        capacity = (int) wanted;
    }

    /** Makes room for the contacts of a step that had too little, and some more. */
    void makeRoom(long contacts) {
        ensure((long) Math.min(Integer.MAX_VALUE, Math.max(contacts, contacts * Tuning.GROWTH)));
    }
}
