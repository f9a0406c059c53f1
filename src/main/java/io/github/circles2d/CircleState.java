package io.github.circles2d;

import io.github.circles2d.pipeline.Tuning;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.Objects;

/** The host's copy of the circles: what snapshots show, what is uploaded after a change. */
final class CircleState implements Snapshot {
    private int count;
    private FloatBuffer circle;
    private FloatBuffer velocities;
    private FloatBuffer velocitiesView;
    private FloatBuffer transforms;
    private FloatBuffer transformsView;
    private boolean transformsFresh;
    private float maxRadius;

    CircleState(int capacity) {
        circle = allocate(4, capacity);
        velocities = allocate(2, capacity);
        velocitiesView = velocities.asReadOnlyBuffer();
        transforms = allocate(4, 0);
        transformsView = transforms.asReadOnlyBuffer();
    }

    private static FloatBuffer allocate(int floats, int circles) {
        try {
            return ByteBuffer.allocateDirect(Math.multiplyExact(4 * floats, circles))
                    .order(ByteOrder.nativeOrder())
                    .asFloatBuffer();
        } catch (OutOfMemoryError e) {
            throw new CapacityException("no direct memory for " + circles + " circles: " + 4L * floats * circles
                    + " bytes wanted (raise -XX:MaxDirectMemorySize): " + e.getMessage());
        }
    }

    private static FloatBuffer grown(FloatBuffer old, int floats, int circles) {
        return allocate(floats, circles).put(old.duplicate().clear()).clear();
    }

    /** Adds a circle and returns its slot. */
    int add(float x, float y, float radius, float mass, float vx, float vy) {
        int room = circle.capacity() / 4;
        if (count == room) {
            if (room == Tuning.MAX_CIRCLES) {
                throw new CapacityException("a world holds at most " + Tuning.MAX_CIRCLES + " circles");
            }
            int more = (int) Math.min(Tuning.MAX_CIRCLES, Math.max(Tuning.FIRST_CIRCLES, room * Tuning.GROWTH));
            FloatBuffer moreVelocities = grown(velocities, 2, more);
            circle = grown(circle, 4, more);
            velocities = moreVelocities;
            velocitiesView = velocities.asReadOnlyBuffer();
        }
        int slot = count++;
        circle.put(4 * slot, x).put(4 * slot + 1, y).put(4 * slot + 2, radius).put(4 * slot + 3, mass);
        maxRadius = Math.max(maxRadius, radius);
        setVelocity(slot, vx, vy);
        return slot;
    }

    void setVelocity(int slot, float vx, float vy) {
        velocities.put(2 * slot, vx).put(2 * slot + 1, vy);
        refreshed();
    }

    /** Says that the buffers have been written to. */
    void refreshed() {
        transformsFresh = false;
    }

    /** (x, y, radius, mass) a circle. */
    FloatBuffer circleBuffer() {
        return circle;
    }

    /** (vx, vy) a circle. */
    FloatBuffer velocityBuffer() {
        return velocities;
    }

    float maxRadius() {
        return maxRadius;
    }

    /** FNV-1a, 64 bits, over the raw bits in slot order, 32 bits at a time. */
    long hash() {
        long hash = 0xcbf29ce484222325L;
        for (int slot = 0; slot < count; slot++) {
            for (int k = 0; k < 4; k++) {
                hash = (hash ^ Float.floatToRawIntBits(circle.get(4 * slot + k)) & 0xFFFFFFFFL) * 0x100000001b3L;
            }
            for (int k = 0; k < 2; k++) {
                hash = (hash ^ Float.floatToRawIntBits(velocities.get(2 * slot + k)) & 0xFFFFFFFFL) * 0x100000001b3L;
            }
        }
        return hash;
    }

    @Override
    public int count() {
        return count;
    }

    @Override
    public float x(int slot) {
        return circle.get(4 * Objects.checkIndex(slot, count));
    }

    @Override
    public float y(int slot) {
        return circle.get(4 * Objects.checkIndex(slot, count) + 1);
    }

    @Override
    public float radius(int slot) {
        return circle.get(4 * Objects.checkIndex(slot, count) + 2);
    }

    @Override
    public float mass(int slot) {
        return circle.get(4 * Objects.checkIndex(slot, count) + 3);
    }

    @Override
    public float vx(int slot) {
        return velocities.get(2 * Objects.checkIndex(slot, count));
    }

    @Override
    public float vy(int slot) {
        return velocities.get(2 * Objects.checkIndex(slot, count) + 1);
    }

    @Override
    public long circleAt(int slot) {
        return Objects.checkIndex(slot, count);
    }

    @Override
    public FloatBuffer transforms() {
        if (transforms.capacity() < 4 * count) {
            transforms = allocate(4, circle.capacity() / 4);
            transformsView = transforms.asReadOnlyBuffer();
            transformsFresh = false;
        }
        if (!transformsFresh) {
            for (int at = 0; at < 4 * count; at += 4) {
                transforms
                        .put(at, circle.get(at))
                        .put(at + 1, circle.get(at + 1))
                        .put(at + 2, circle.get(at + 2));
            }
            transformsFresh = true;
        }
        return transformsView.clear().limit(4 * count);
    }

    @Override
    public FloatBuffer velocities() {
        return velocitiesView.clear().limit(2 * count);
    }
}
