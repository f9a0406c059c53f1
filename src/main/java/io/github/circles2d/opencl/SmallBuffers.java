package io.github.circles2d.opencl;

import io.github.circles2d.CapacityException;
import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Tuning;

/** The buffers of small steps that every detection shares; {@link Turn} has the others. Named as the kernels name them. */
final class SmallBuffers {
    /** A contact as it is found, an int4. */
    private static final long FOUND_BYTES = 16;

    /** By number: kept from step to step. */
    final DeviceBuffer walls;

    final DeviceBuffer kick;
    /** By number: the level of each circle. */
    final DeviceBuffer levelOf;

    /** By place. */
    final DeviceBuffer kicked;

    final DeviceBuffer bucket;
    final DeviceBuffer unsorted;
    final DeviceBuffer bucketStart;
    final DeviceBuffer partSums;
    final DeviceBuffer found;
    final DeviceBuffer foundOwner;
    final DeviceBuffer byOwner;
    final DeviceBuffer ownerOf;
    final DeviceBuffer pair;
    final DeviceBuffer rule;
    final Turn[] turns = new Turn[2];

    private int capacity;

    SmallBuffers(Session session) {
        walls = new DeviceBuffer(session, "walls");
        kick = new DeviceBuffer(session, "kick");
        levelOf = new DeviceBuffer(session, "levelOf");
        kicked = new DeviceBuffer(session, "kicked");
        bucket = new DeviceBuffer(session, "bucket");
        unsorted = new DeviceBuffer(session, "unsorted");
        bucketStart = new DeviceBuffer(session, "bucketStart");
        partSums = new DeviceBuffer(session, "partSums");
        found = new DeviceBuffer(session, "found");
        foundOwner = new DeviceBuffer(session, "foundOwner");
        byOwner = new DeviceBuffer(session, "byOwner");
        ownerOf = new DeviceBuffer(session, "ownerOf");
        pair = new DeviceBuffer(session, "pair");
        rule = new DeviceBuffer(session, "rule");
        turns[0] = new Turn(session);
        turns[1] = new Turn(session);
    }

    /** Makes room for circles, as many as {@code room}; keeps what is kept by number. */
    void ensureCircles(Levels levels, int room) {
        walls.grow(32L * room, 0);
        kick.grow(8L * room, 0);
        levelOf.ensure(4L * room);
        kicked.ensure(8L * room);
        bucket.ensure(4L * room);
        unsorted.ensure(4L * room);
        bucketStart.ensure(4L * (levels.cells + 1));
        // one sum for each group, and a group may be of one work-item
        partSums.ensure(4L * (levels.cells / Tuning.SCAN + 1));
        for (Turn turn : turns) {
            turn.ensureCircles(room);
        }
    }

    int capacity() {
        return capacity;
    }

    /** Makes room for at least so many contacts; keeps what is remembered of those there are. */
    void ensureContacts(long wanted) {
        if (wanted <= capacity) {
            return;
        }
        if (wanted > Integer.MAX_VALUE) {
            throw new CapacityException("a step found " + wanted + " contacts; a world has room for 2^31 - 1");
        }
        capacity = 0;
        found.ensure(FOUND_BYTES * wanted);
        foundOwner.ensure(4 * wanted);
        byOwner.ensure(FOUND_BYTES * wanted);
        ownerOf.ensure(4 * wanted);
        pair.ensure(8 * wanted);
        for (Turn turn : turns) {
            turn.growContacts(wanted);
        }
        capacity = (int) wanted;
    }
}
