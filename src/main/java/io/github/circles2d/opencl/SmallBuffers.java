package io.github.circles2d.opencl;

import io.github.circles2d.CapacityException;
import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Substeps;
import io.github.circles2d.pipeline.Tuning;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** The buffers of small steps that every detection shares; {@link Turn} has the others. Named as the kernels name them. */
final class SmallBuffers {
    /** By number: kept from step to step. */
    final DeviceBuffer walls;

    /** By place. */
    final DeviceBuffer kicked;

    final DeviceBuffer from;
    final DeviceBuffer bucketStart;
    final DeviceBuffer partSums;
    final DeviceBuffer levels;
    final DeviceBuffer rule;
    final Turn[] turns = new Turn[2];

    private int capacity;

    SmallBuffers(Session session) {
        walls = new DeviceBuffer(session, "walls");
        kicked = new DeviceBuffer(session, "kicked");
        from = new DeviceBuffer(session, "from");
        bucketStart = new DeviceBuffer(session, "bucketStart");
        partSums = new DeviceBuffer(session, "partSums");
        levels = new DeviceBuffer(session, "levels");
        rule = new DeviceBuffer(session, "rule");
        rule.ensure(4L * Substeps.NUMBERS);
        turns[0] = new Turn(session);
        turns[1] = new Turn(session);
    }

    /** Makes room for circles, as many as {@code room}, and their cells; keeps what is kept from step to step. */
    void ensureCircles(Levels now, int room) {
        walls.grow(16L * room, 0);
        kicked.ensure(8L * room);
        from.ensure(4L * room);
        bucketStart.ensure(4L * (now.cells + 1));
        // one sum for each group, and a group may be of one work-item
        partSums.ensure(4L * (Math.max(now.cells, room) / Tuning.SCAN + 1));
        for (Turn turn : turns) {
            turn.growCircles(room);
        }
        levels.ensure(4L * now.table.length);
        ByteBuffer copy = ByteBuffer.allocateDirect(4 * now.table.length).order(ByteOrder.nativeOrder());
        copy.asIntBuffer().put(now.table);
        levels.write(copy, 4L * now.table.length);
    }

    int capacity() {
        return capacity;
    }

    /** Makes room for at least so many contacts; keeps what is remembered of those there are. */
    void ensureContacts(long wanted) {
        if (wanted <= capacity) {
            return;
        }
        if (wanted >= Integer.MAX_VALUE) {
            throw new CapacityException("a step found " + wanted + " contacts; a world has room for 2^31 - 2");
        }
        capacity = 0;
        for (Turn turn : turns) {
            turn.growContacts(wanted);
        }
        capacity = (int) wanted;
    }
}
