package io.github.circles2d;

import java.nio.FloatBuffer;

/**
 * The circles as they were when {@link Circles2D#snapshot()} was last called, in slots 0 to {@link #count()} - 1. One
 * object a world, refreshed by that call, and by those that add circles, set velocities or read the state back; read it in
 * the thread that uses the world. A slot out of range throws {@link IndexOutOfBoundsException}. It stays readable after the
 * world is closed.
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
     * (x, y, radius, angle) a circle, ready to instance from: direct, read-only, native order, position 0, limit 4 * count. The same
     * buffer until the world grows. Angles are 0: circles do not turn yet.
     */
    FloatBuffer transforms();

    /** (vx, vy) a circle: direct, read-only, native order, position 0, limit 2 * count. The same buffer until the world grows. */
    FloatBuffer velocities();
}
