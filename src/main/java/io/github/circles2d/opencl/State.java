package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Status;
import io.github.circles2d.pipeline.Tuning;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import org.jocl.Pointer;

/**
 * The circles on the device and what it has done: the buffers {@code circle}, {@code velocities} and {@code status} of the
 * kernels. They are parts of one buffer, so that a small world comes back in one transfer: each costs a GPU some
 * microseconds, however small.
 */
final class State {
    private static final int STATUS_BYTES = 16;

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
    private ByteBuffer copy = direct(0);
    private Pointer copyPointer;
    /** The copy holds all of the device's state, not only its status. */
    private boolean copyWhole;

    private final Status done = new Status();
    private int updatesSeen;

    State(Session session) {
        this.session = session;
        alignment = session.device.partAlignment;
        whole = new DeviceBuffer(session, "state");
        status = new DeviceBuffer(session, "status");
        circle = new DeviceBuffer(session, "circle");
        velocities = new DeviceBuffer(session, "velocities");
    }

    private static ByteBuffer direct(int bytes) {
        return ByteBuffer.allocateDirect(bytes).order(ByteOrder.nativeOrder());
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
        int copied = oneTransfer() ? (int) bytes : STATUS_BYTES;
        if (copy.capacity() < copied) {
            copy = direct(copied);
            copyPointer = Pointer.to(copy);
        }
    }

    private boolean oneTransfer() {
        return bytes <= Tuning.ONE_TRANSFER_BYTES;
    }

    void upload(FloatBuffer newCircle, FloatBuffer newVelocities, int count) {
        if (count != circles || bytes == 0) {
            lay(count);
            clearStatus();
        }
        circle.write(newCircle, 16L * count);
        velocities.write(newVelocities, 8L * count);
        circles = count;
        copyWhole = false;
    }

    /** What the device says of itself. Waits for all that is queued; a small world comes back whole. */
    Status await() {
        copyWhole = oneTransfer();
        whole.read(0, copyPointer, copyWhole ? bytes : STATUS_BYTES);
        if (session.compiles) {
            session.compiles = false;
            SignalCanary.handBack();
        }
        int updates = copy.getInt(8) - updatesSeen;
        updatesSeen = copy.getInt(8);
        if (copy.getInt(4) == TOO_DENSE) {
            throw Status.tooDense();
        }
        return done.set(Integer.toUnsignedLong(copy.getInt(0)), copy.getInt(4) != 0, updates);
    }

    OpenClDevice device() {
        return session.device;
    }

    /** The highest speed after the last step, radii a second; after {@link #await()}, of small steps. */
    float fastest() {
        return copy.getFloat(12);
    }

    /** Says that kernels have been queued that change the circles. */
    void changes() {
        copyWhole = false;
    }

    /** Reads the circles. Waits. */
    void download(FloatBuffer toCircle, FloatBuffer toVelocities) {
        if (!copyWhole) {
            circle.read(0, toCircle, 16L * circles);
            velocities.read(0, toVelocities, 8L * circles);
            return;
        }
        for (int k = 0; k < 4 * circles; k++) {
            toCircle.put(k, copy.getFloat((int) circleAt + 4 * k));
        }
        for (int k = 0; k < 2 * circles; k++) {
            toVelocities.put(k, copy.getFloat((int) velocitiesAt + 4 * k));
        }
    }

    /** As if no step had been made since the upload; the circles stay. */
    void clearStatus() {
        for (int at = 0; at < STATUS_BYTES; at += 4) {
            copy.putInt(at, 0);
        }
        updatesSeen = 0;
        copyWhole = false;
        status.write(copy, STATUS_BYTES);
    }
}
