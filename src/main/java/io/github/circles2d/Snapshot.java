package io.github.circles2d;

import java.nio.FloatBuffer;

/**
 * The circles as they were when {@link Circles2D#snapshot()} was last called, in slots 0 to {@link #count()} - 1. One
 * object a world, refreshed by that call, and by those that add circles, set velocities or read the state back; read it in
 * the thread that uses the world. A slot out of range throws {@link IndexOutOfBoundsException}. It stays readable after the
 * world is closed.
 *
 * <p>With {@link Circles2D.Builder#background} there are two sets of buffers. The first call that reads the circles back after a
 * step, {@link Circles2D#snapshot()} or another, goes over to the other set, and the next step begins to write to the one that was
 * shown before. So a buffer taken from a snapshot stays as it is until the first {@link Circles2D#step()} after the next {@code
 * snapshot()} that follows a step: a frame longer than without. To the set that is shown only {@link Circles2D#addCircle} and {@link
 * Circles2D#setVelocity} write. A buffer that a growing world has replaced stays as it is.
 */
public interface Snapshot {
    /** Number of circles. */
    int count();

    /** Centre, world units. */
    float x(int slot);

    /** Centre, world units. */
    float y(int slot);

    /** Radius, world units. */
    float radius(int slot);

    /** Mass, in the caller's unit. */
    float mass(int slot);

    /** Velocity, world units a second. */
    float vx(int slot);

    /** Velocity, world units a second. */
    float vy(int slot);

    /** The handle of the circle in a slot, as {@link Circles2D#addCircle} gave it. */
    long circleAt(int slot);

    /**
     * (x, y, radius, angle) a circle, ready to instance from: direct, read-only, native order, position 0, limit 4 * count. Angles are 0:
     * circles do not turn yet. The same buffer until the world grows; with {@link Circles2D.Builder#background}, one of two in turn, as
     * the class comment says.
     */
    FloatBuffer transforms();

    /**
     * (vx, vy) a circle: direct, read-only, native order, position 0, limit 2 * count. The same buffer until the world grows, or one of
     * two in turn, as {@link #transforms()}.
     */
    FloatBuffer velocities();
}
