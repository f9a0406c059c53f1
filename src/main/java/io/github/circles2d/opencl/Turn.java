package io.github.circles2d.opencl;

/**
 * The buffers of small steps that a detection writes while it reads those of the detection before: two of each, used in
 * turn. While it sorts, a detection keeps what it does not need later in those that it fills last: in {@link #other} the
 * circles by bucket, in {@link #memory} the contacts as they are found, in the {@link #body} of the detection before the pairs that find
 * keeps. Once it has what it needs of the detection before, the
 * buffers of that one are free, and hold the order in which contacts are solved until the next: kernels/batch.cl.
 */
final class Turn {
    final DeviceBuffer body;
    final DeviceBuffer id;
    final DeviceBuffer listStart;
    final DeviceBuffer other;
    final DeviceBuffer memory;

    Turn(Session session) {
        body = new DeviceBuffer(session, "body");
        id = new DeviceBuffer(session, "id");
        listStart = new DeviceBuffer(session, "listStart");
        other = new DeviceBuffer(session, "other");
        memory = new DeviceBuffer(session, "memory");
    }

    void growCircles(int room) {
        body.grow(32L * room, 0);
        id.grow(4L * room, 0);
        listStart.grow(4L * (room + 1), 0);
        other.grow(4L * room, 0);
    }

    void growContacts(long wanted) {
        other.grow(4 * wanted, 0);
        memory.grow(8 * wanted, 0);
        // as the other turn's `batch`, three ints a contact, and `tint`, a short
        body.grow(12 * wanted, 0);
        listStart.grow(2 * wanted, 0);
    }
}
