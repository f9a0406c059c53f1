package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Levels;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.jocl.cl_mem;

/**
 * The buffers of small steps that a detection writes while it reads those of the detection before: two of each, used in
 * turn.
 */
final class Turn {
    final DeviceBuffer body;
    final DeviceBuffer id;
    /** By number. */
    final DeviceBuffer cell;

    final DeviceBuffer levels;
    final DeviceBuffer ownerStart;
    final DeviceBuffer ids;
    final DeviceBuffer memory;

    /** Of the detection that was made with these buffers. */
    int cells;

    Turn(Session session) {
        body = new DeviceBuffer(session, "body");
        id = new DeviceBuffer(session, "id");
        cell = new DeviceBuffer(session, "cell");
        levels = new DeviceBuffer(session, "levels");
        ownerStart = new DeviceBuffer(session, "ownerStart");
        ids = new DeviceBuffer(session, "ids");
        memory = new DeviceBuffer(session, "memory");
        levels.ensure(4L * Levels.INTS);
        ownerStart.grow(16, 0);
    }

    void ensureCircles(int room) {
        body.ensure(32L * room);
        id.ensure(4L * room);
        // level -1: not there yet
        cell.grow(16L * room, -1);
    }

    void growContacts(long wanted) {
        ids.grow(8 * wanted, 0);
        memory.grow(8 * wanted, 0);
    }

    /**
     * Readies these buffers for a detection with these cells; what the last one left in them is not needed any more. Says
     * whether a buffer had to move.
     */
    boolean ready(Levels now) {
        cl_mem levelsAt = levels.memory();
        cl_mem ownersAt = ownerStart.memory();
        int count = now.table.length;
        levels.ensure(4L * count);
        ownerStart.ensure(4L * (now.cells + 1));
        if (count > 0) {
            ByteBuffer copy = ByteBuffer.allocateDirect(4 * count).order(ByteOrder.nativeOrder());
            copy.asIntBuffer().put(now.table);
            levels.write(copy, 4L * count);
        }
        cells = now.cells;
        return levels.memory() != levelsAt || ownerStart.memory() != ownersAt;
    }
}
