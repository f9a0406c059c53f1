package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Changes;
import io.github.circles2d.pipeline.Motion;
import io.github.circles2d.pipeline.Population;
import io.github.circles2d.pipeline.Status;
import io.github.circles2d.pipeline.Tuning;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;

/**
 * The circles on the device and what it has done: the buffers {@code circle}, {@code velocities} and {@code status} of the
 * kernels. They are parts of one buffer, so that a small world comes back in one transfer: each costs a GPU some
 * microseconds, however small.
 */
final class State {
    private static final int MOTION = 16;
    private static final int STATUS_BYTES = (MOTION + 4 * (Motion.NUMBERS + 1) + 15) / 16 * 16;

    /** {@code C2D_TOO_DENSE}. */
    private static final int TOO_DENSE = 2;

    final DeviceBuffer status;
    final DeviceBuffer circle;
    final DeviceBuffer velocities;
    int circles;

    private final Session session;
    private final DeviceBuffer whole;
    private final int alignment;
    private long circleAt;
    private long velocitiesAt;
    private long bytes;
    private final Staging staging;
    private final StagedCircles staged;
    /** The staging memory holds all of the device's state. */
    private boolean stagedWhole;

    private final Motion motion = new Motion();
    private int tiles;

    private final Status done = new Status();
    private int updatesSeen;

    State(Session session) {
        this.session = session;
        alignment = session.device.partAlignment;
        whole = new DeviceBuffer(session, "state");
        status = new DeviceBuffer(session, "status");
        circle = new DeviceBuffer(session, "circle");
        velocities = new DeviceBuffer(session, "velocities");
        staging = new Staging(session);
        staged = new StagedCircles(staging);
    }

    private long aligned(long offset) {
        return (offset + alignment - 1) / alignment * alignment;
    }

    private void lay(int count) {
        circleAt = aligned(STATUS_BYTES);
        velocitiesAt = aligned(circleAt + 16L * count);
        bytes = velocitiesAt + 8L * count;
        whole.ensure(bytes + alignment);
        status.become(whole, 0, STATUS_BYTES);
        circle.become(whole, circleAt, 16L * count);
        velocities.become(whole, velocitiesAt, 8L * count);
        staging.ensure((int) Math.min(bytes, Tuning.STAGING_BYTES));
    }

    private boolean oneTransfer() {
        return bytes <= Tuning.ONE_TRANSFER_BYTES;
    }

    void upload(Population population, FloatBuffer newVelocities) {
        int count = population.circles();
        if (count != circles || bytes == 0) {
            lay(count);
            clearStatus();
        }
        circles = count;
        stagedWhole = false;
        write(circleAt, population.transforms(), population.masses(), StagedCircles.TRANSFORM, 0, count);
        write(velocitiesAt, newVelocities, null, StagedCircles.VELOCITY, 0, count);
    }

    void velocities(FloatBuffer newVelocities, Changes changed) {
        stagedWhole = false;
        changed.rewind(circles, Tuning.CHANGED_APART);
        while (changed.next()) {
            write(velocitiesAt, newVelocities, null, StagedCircles.VELOCITY, changed.from(), changed.end());
        }
    }

    /** What the device says of itself. Waits for all that is queued; a small world that is to be read comes back whole. */
    Status await(boolean reading) {
        stagedWhole = reading && oneTransfer();
        whole.read(0, staging.pointer(), stagedWhole ? bytes : STATUS_BYTES);
        if (session.compiles) {
            session.compiles = false;
            SignalCanary.handBack();
        }
        ByteBuffer said = staging.bytes();
        int updates = said.getInt(8) - updatesSeen;
        updatesSeen = said.getInt(8);
        tiles = said.getInt(12);
        motion.set(said, MOTION);
        if (said.getInt(4) == TOO_DENSE) {
            throw Status.tooDense();
        }
        return done.set(Integer.toUnsignedLong(said.getInt(0)), said.getInt(4) != 0, updates);
    }

    /** How the circles move after the last step; after {@link #await}, of small steps. */
    Motion motion() {
        return motion;
    }

    /** How many tiles of a tiling had anything in them in the last step; 0 if nobody knows. */
    int tiles() {
        return tiles;
    }

    /** Says that kernels have been queued that change the circles. */
    void changes() {
        stagedWhole = false;
    }

    /** Reads the circles. Waits. */
    void download(FloatBuffer transforms, FloatBuffer toVelocities) {
        if (stagedWhole) {
            staged.toHost((int) circleAt / 4, transforms, StagedCircles.TRANSFORM, 0, circles);
            staged.toHost((int) velocitiesAt / 4, toVelocities, StagedCircles.VELOCITY, 0, circles);
            return;
        }
        read(circleAt, transforms, StagedCircles.TRANSFORM);
        read(velocitiesAt, toVelocities, StagedCircles.VELOCITY);
    }

    /** How many circles of so many floats the staging memory has room for. */
    private int mostStaged(int floats) {
        return staging.room() / (4 * floats);
    }

    /** Writes circles {@code begin .. end - 1} of a part of the whole, as many at a time as the staging memory has room for. */
    private void write(long to, FloatBuffer from, FloatBuffer masses, int floats, int begin, int end) {
        int most = mostStaged(floats);
        for (int first = begin; first < end; first += most) {
            int some = Math.min(end - first, most);
            staged.toStaging(from, masses, floats, first, some);
            whole.write(to + 4L * floats * first, staging.pointer(), 4L * floats * some);
        }
    }

    /** All of them the same way back. */
    private void read(long from, FloatBuffer to, int floats) {
        int most = mostStaged(floats);
        for (int first = 0; first < circles; first += most) {
            int some = Math.min(circles - first, most);
            whole.read(from + 4L * floats * first, staging.pointer(), 4L * floats * some);
            staged.toHost(0, to, floats, first, some);
        }
    }

    /** As if no step had been made since the upload; the circles stay. */
    void clearStatus() {
        for (int at = 0; at < STATUS_BYTES; at += 4) {
            staging.bytes().putInt(at, 0);
        }
        updatesSeen = 0;
        tiles = 0;
        stagedWhole = false;
        status.write(staging.pointer(), STATUS_BYTES);
    }
}
