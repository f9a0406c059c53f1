package io.github.circles2d.pipeline;

import io.github.circles2d.CapacityException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;

/**
 * What a step changes of the circles, in the host's memory: what is uploaded and read back, and what a renderer instances from. The views
 * are given to users, so that only what is asked for their sake moves their limits. Not thread-safe.
 */
public final class CircleBuffers {
    private FloatBuffer transforms = allocate(4, 0);
    private FloatBuffer transformsView;
    private FloatBuffer velocities = allocate(2, 0);
    private FloatBuffer velocitiesView;

    /**
     * Buffers for so many circles.
     *
     * @throws CapacityException if Java has no direct memory for them; so do the methods that grow them
     */
    public CircleBuffers(int room) {
        grow(room);
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

    /** A direct buffer for so many floats of each of so many circles, which begins with all that is in another; null: empty. */
    public static FloatBuffer grown(FloatBuffer old, int floats, int circles) {
        FloatBuffer grown = allocate(floats, circles);
        return old == null ? grown : grown.put(old.duplicate().clear()).clear();
    }

    /** How many circles there is room for. */
    public int room() {
        return velocities.capacity() / 2;
    }

    /** Makes room for more circles, and keeps those there are. */
    public void grow(int more) {
        FloatBuffer moreVelocities = grown(velocities, 2, more);
        transforms = grown(transforms, 4, more);
        velocities = moreVelocities;
        transformsView = transforms.asReadOnlyBuffer();
        velocitiesView = velocities.asReadOnlyBuffer();
    }

    /** Sees to it that there is room for so many circles. */
    public void reserve(int circles) {
        if (room() < circles) {
            grow(circles);
        }
    }

    /** (x, y, radius, angle) a circle, world units; angles are 0. */
    public FloatBuffer transforms() {
        return transforms;
    }

    /** (vx, vy) a circle, world units a second. */
    public FloatBuffer velocities() {
        return velocities;
    }

    /** {@link #transforms} of so many, read-only. */
    public FloatBuffer transformsView(int circles) {
        return transformsView.clear().limit(4 * circles);
    }

    /** {@link #velocities} of so many, read-only. */
    public FloatBuffer velocitiesView(int circles) {
        return velocitiesView.clear().limit(2 * circles);
    }

    /** Makes transforms of what devices have, (x, y, radius, mass) a circle, where they have been copied as they are. */
    public static void setAngles(FloatBuffer transforms, int from, int end) {
        for (int i = from; i < end; i += Tuning.CIRCLES_A_CALL) {
            setAnglesOfFew(transforms, i, Math.min(end, i + Tuning.CIRCLES_A_CALL));
        }
    }

    private static void setAnglesOfFew(FloatBuffer transforms, int from, int end) {
        for (int i = from; i < end; i++) {
            transforms.put(4 * i + 3, 0);
        }
    }
}
