package io.github.circles2d.opencl;

import io.github.circles2d.CapacityException;
import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Substeps;
import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.Tuning;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** The buffers of small steps that every detection shares; {@link Turn} has the others. Named as the kernels name them. */
final class SmallBuffers {
    /** {@code batch} has three ints a contact, and ints say where. */
    static final int MOST_CONTACTS = Integer.MAX_VALUE / 3;

    /** By number: kept from step to step. */
    final DeviceBuffer walls;

    /** By place. */
    final DeviceBuffer kicked;

    final DeviceBuffer from;
    final DeviceBuffer bucketStart;
    final DeviceBuffer partSums;
    final DeviceBuffer levels;
    final DeviceBuffer tilings;
    final DeviceBuffer tileStart;
    final DeviceBuffer tileColours;
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
        tilings = new DeviceBuffer(session, "tilings");
        tileStart = new DeviceBuffer(session, "tileStart");
        tileColours = new DeviceBuffer(session, "tileColours");
        rule = new DeviceBuffer(session, "rule");
        rule.ensure(4L * Substeps.NUMBERS);
        turns[0] = new Turn(session);
        turns[1] = new Turn(session);
    }

    /** Makes room for circles, as many as {@code room}, and their cells; keeps what is kept from step to step. */
    void ensureCircles(Levels now, Tiles tiles, int room) {
        walls.grow(16L * room, 0);
        kicked.ensure(8L * room);
        from.ensure(4L * room);
        tileStart.ensure(4L * (tiles.parts() + 1));
        tileColours.ensure(4L * tiles.tiles);
        bucketStart.ensure(4L * (now.cells + 1));
        // one sum for each group, and a group may be of one work-item
        partSums.ensure(4L * (Math.max(Math.max(now.cells, tiles.parts()), room) / Tuning.SCAN + 1));
        for (Turn turn : turns) {
            turn.growCircles(room);
        }
        write(levels, now.table);
        write(tilings, tiles.table);
    }

    private static void write(DeviceBuffer buffer, int[] values) {
        buffer.ensure(4L * values.length);
        ByteBuffer copy = ByteBuffer.allocateDirect(4 * values.length).order(ByteOrder.nativeOrder());
        copy.asIntBuffer().put(values);
        buffer.write(copy, 4L * values.length);
    }

    int capacity() {
        return capacity;
    }

    /** Makes room for at least so many contacts; keeps what is remembered of those there are. */
    void ensureContacts(long wanted) {
        if (wanted <= capacity) {
            return;
        }
        if (wanted > MOST_CONTACTS) {
            throw new CapacityException("a step found " + wanted + " contacts; a world has room for " + MOST_CONTACTS);
        }
        capacity = 0;
        for (Turn turn : turns) {
            turn.growContacts(wanted);
        }
        capacity = (int) wanted;
    }
}
