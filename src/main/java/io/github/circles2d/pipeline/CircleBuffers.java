package io.github.circles2d.pipeline;

import io.github.circles2d.CapacityException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;

/**
 * The circles in the host's memory: what is uploaded and read back, and what a renderer instances from. The views are given to users, so
 * that only what is asked for their sake moves their limits. Not thread-safe.
 */
public final class CircleBuffers {
    private FloatBuffer circle;
    private FloatBuffer velocities;
    private FloatBuffer velocitiesView;
    private FloatBuffer transforms;
    private FloatBuffer transformsView;
    private boolean transformsFresh;

    /**
     * Buffers for so many circles.
     *
     * @throws CapacityException if Java has no direct memory for them; so do the methods that grow them
     */
    public CircleBuffers(int room) {
        circle = allocate(4, room);
        velocities = allocate(2, room);
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

    /** How many circles there is room for. */
    public int room() {
        return circle.capacity() / 4;
    }

    /** Makes room for more circles, and keeps those there are. */
    public void grow(int more) {
        FloatBuffer moreVelocities = grown(velocities, 2, more);
        circle = grown(circle, 4, more);
        velocities = moreVelocities;
        velocitiesView = velocities.asReadOnlyBuffer();
    }

    /** Sees to it that neither {@link #prepare} nor a download allocates with up to so many circles. */
    public void reserve(int circles) {
        if (room() < circles) {
            grow(circles);
        }
        if (transforms.capacity() < 4 * circles) {
            transforms = allocate(4, room());
            transformsView = transforms.asReadOnlyBuffer();
            transformsFresh = false;
        }
    }

    /** (x, y, radius, mass) a circle, world units. */
    public FloatBuffer circle() {
        return circle;
    }

    /** (vx, vy) a circle, world units a second. */
    public FloatBuffer velocities() {
        return velocities;
    }

    /** Says that the circles have been written to. */
    public void changed() {
        transformsFresh = false;
    }

    /** Writes what {@link #transformsView} shows, unless that is so already. */
    public void prepare(int circles) {
        reserve(circles);
        if (!transformsFresh) {
            transforms.put(0, circle, 0, 4 * circles);
            for (int angle = 3; angle < 4 * circles; angle += 4) {
                transforms.put(angle, 0);
            }
            transformsFresh = true;
        }
    }

    /** (x, y, radius, 0) a circle, read-only. */
    public FloatBuffer transformsView(int circles) {
        prepare(circles);
        return transformsView.clear().limit(4 * circles);
    }

    /** (vx, vy) a circle, read-only. */
    public FloatBuffer velocitiesView(int circles) {
        return velocitiesView.clear().limit(2 * circles);
    }
}
