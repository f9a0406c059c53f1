package io.github.circles2d;

import io.github.circles2d.pipeline.WorldConfig;

/**
 * A world of rigid circles inside a box of walls.
 *
 * <pre>{@code
 * try (Circles2D world = Circles2D.builder().gravity(0, -1).build()) {
 *     long ball = world.addCircle(0.5f, 0.9f, 0.05f, 1);
 *     for (int frame = 0; frame < 60; frame++) {
 *         world.step();
 *         Snapshot now = world.snapshot();
 *         draw(now.transforms(), now.count());
 *     }
 * }
 * }</pre>
 *
 * <p>The same calls give the same bits on every device that says {@link ComputeDevice#deterministic()}, in every run,
 * for every {@link IndexStrategy} and {@link CollisionStore}: {@link #stateHash()} shows it.
 *
 * <p><b>Threads.</b> For one thread at a time; which one may change. Calls from several are done one after the other, in
 * no particular order. Worlds share nothing: each thread can have its own. With {@link Builder#background} a world has a thread of
 * its own besides, which makes the steps: {@link #step()} hands them over and returns, {@link #snapshot()} waits for those that are
 * not done yet and shows what that thread has read back. Every other call but {@link #circleCount()} and {@link #device()} waits for it
 * too. Waiting goes on through an interrupt, and the thread that waited is interrupted then. The bits are the same.
 *
 * <p><b>Errors.</b> When a device fails in a step the call throws a {@link Circles2DException} and the world has failed:
 * every later call but {@link #close()} throws again, with the first failure as its cause. In the background it is the next call
 * that throws it, whichever that is, and no step is made after it. A {@link Snapshot} taken before stays readable. After {@link
 * #close()} every call throws {@link IllegalStateException}.
 */
public final class Circles2D implements AutoCloseable {
    private final ComputeDevice device;
    private final WorldConfig config;
    private final WorldState state;
    private final LeakReporter leak;
    private boolean closed;

    Circles2D(ComputeDevice device, WorldConfig config, int capacity, boolean background) {
        this.device = device;
        this.config = config;
        state = new WorldState(device, config, capacity, background);
        leak = LeakReporter.watch(this, device.toString(), state::abandon);
    }

    /** A builder with the defaults of {@link Builder}. */
    public static Builder builder() {
        return new WorldBuilder();
    }

    /** What a world is made from. Each method checks its argument at once and returns this builder. */
    public interface Builder {
        /** Where the world runs. Default {@link ComputeDevice#preferred()}. */
        Builder device(ComputeDevice device);

        /** How detect finds its pairs. Default {@link IndexStrategy#grid()}. Never changes the result. */
        Builder indexStrategy(IndexStrategy strategy);

        /** Where detect leaves the contacts. Default {@link CollisionStore#COMPACT}. Never changes the result. */
        Builder collisionStore(CollisionStore store);

        /** How contacts are resolved. Default {@link Solver#SMALL_STEPS}. */
        Builder solver(Solver solver);

        /** Time of one step, seconds, 1e-9 to 1e3. Default 1/60. */
        Builder timeStep(float seconds);

        /**
         * Substeps of a step of {@link Solver#SMALL_STEPS}, 1 to 512; 0, the default, to choose them before each step
         * from the depth of the pile that the circles would make and from their speeds.
         */
        Builder substeps(int count);

        /** Gravity, world units / s^2, each component within 1e9. Default (0, -1). */
        Builder gravity(float ax, float ay);

        /** Restitution of circles and walls, 0 (no bounce) to 1 (no loss). Default 0.5. */
        Builder restitution(float e);

        /** The walls, world units, within 1e9. Default the unit square. */
        Builder bounds(float minX, float minY, float maxX, float maxY);

        /** How many circles to make room for; a hint, the world grows. */
        Builder capacity(int circles);

        /**
         * Whether a daemon thread of the world's own makes the steps and reads the circles back, so that the caller need not wait for
         * either. Default false. It takes a second set of the buffers of {@link Snapshot}, where it says how long each stays as it is; a
         * step that is waited for at once takes some 10 us longer. Never changes the result.
         */
        Builder background(boolean background);

        /**
         * Builds the world; compiles the kernels.
         *
         * @throws NoDeviceException if no device was given and the preferred one, named by property or environment, is
         *     not there
         * @throws KernelBuildException if the driver does not compile the kernels
         * @throws OpenClException if the driver fails otherwise
         */
        Circles2D build();
    }

    /**
     * Adds a circle at rest. A circle that reaches over a wall is moved inside by the next step.
     *
     * @param x centre, world units, inside the bounds
     * @param y centre, world units, inside the bounds
     * @param radius world units, 1e-9 to 1e9, at most half of the shorter side of the bounds
     * @param mass any unit, 1e-9 to 1e9
     * @return the handle of the circle
     * @throws IllegalArgumentException if an argument is out of its range; the world is unchanged
     * @throws CapacityException if Java has no memory for another circle
     */
    public synchronized long addCircle(float x, float y, float radius, float mass) {
        return add(x, y, radius, mass, 0, 0);
    }

    /** Adds the circle that {@code def} describes; as {@link #addCircle(float, float, float, float)}, with a velocity. */
    public synchronized long addCircle(CircleDef def) {
        requireUsable();
        Check.given("def", def);
        return add(def.x, def.y, def.radius, def.mass, def.vx, def.vy);
    }

    private long add(float x, float y, float radius, float mass, float vx, float vy) {
        requireUsable();
        Check.circle(config, x, y, radius, mass);
        Check.velocity(vx, vy);
        return state.toChange().add(x, y, radius, mass, vx, vy);
    }

    /**
     * Adds circles at rest, several times as fast as one after the other: a level that is loaded. All of them or none.
     *
     * @param circles (x, y, radius, mass) of each, as {@link #addCircle(float, float, float, float)} wants them; copied
     * @return the handle of the first; those of the others follow, each one more
     * @throws IllegalArgumentException if a number is out of its range, which the message names with its circle's place in the array, or
     *     the array ends within a circle; the world is unchanged
     * @throws CapacityException if Java has no memory for them; the world is unchanged
     */
    public synchronized long addCircles(float[] circles) {
        return addAll(circles, null);
    }

    /**
     * The same with velocities.
     *
     * @param velocities (vx, vy) of each, as {@link #setVelocity} wants them; copied
     */
    public synchronized long addCircles(float[] circles, float[] velocities) {
        return addAll(circles, Check.given("velocities", velocities));
    }

    private long addAll(float[] circles, float[] velocities) {
        requireUsable();
        Check.circles(config, circles, velocities);
        return state.toChange().addAll(circles, velocities);
    }

    /**
     * Sets the velocity of a circle, from the next step on.
     *
     * @param circle a handle of this world
     * @param vx world units a second, within 1e9
     * @param vy world units a second, within 1e9
     * @throws IllegalArgumentException if an argument is out of its range; the world is unchanged
     */
    public synchronized void setVelocity(long circle, float vx, float vy) {
        requireUsable();
        int count = state.circles().count();
        if (circle < 0 || circle >= count) {
            throw new IllegalArgumentException(
                    "circle = " + circle + ": not a handle of this world, which has " + count + " circles");
        }
        Check.velocity(vx, vy);
        state.toChange().setVelocity((int) circle, vx, vy);
    }

    /** Number of circles. */
    public synchronized int circleCount() {
        requireUsable();
        return state.circles().count();
    }

    /**
     * One time step. Queues the work and need not wait for it. In the background it never does, however many earlier steps are not done
     * yet, unless circles were added since the last: those it sends to the device first.
     */
    public synchronized void step() {
        step(1);
    }

    /**
     * Several time steps; the same as as many calls of {@link #step()}.
     *
     * @param count 0 or more
     */
    public synchronized void step(int count) {
        requireUsable();
        Check.range("steps", count, 0, Integer.MAX_VALUE);
        if (count > 0) {
            state.step(count);
        }
    }

    /** The circles after the last step. Waits for it. Always the same object, refreshed. */
    public synchronized Snapshot snapshot() {
        requireUsable();
        return state.latest();
    }

    /**
     * A hash of the raw bits of every circle's centre, radius, mass and velocity, in the order the circles were added in.
     * The same calls give the same hash on every deterministic device. Waits for the last step.
     */
    public synchronized long stateHash() {
        requireUsable();
        return state.latest().hash();
    }

    /** What the last step looked like; before the first, the circles alone. Waits for it; computed on the device. */
    public synchronized StepStats stats() {
        requireUsable();
        return state.stats();
    }

    /**
     * How much of its device's memory the world holds now, bytes, tables of the index strategy included: under {@link
     * Solver#SMALL_STEPS} with {@link IndexStrategy#grid()} some 220 a circle. Memory of the host, through which circles come and
     * go, does not count. 0 before the first step and on the host device, whose memory is Java's heap.
     */
    public synchronized long deviceMemory() {
        requireUsable();
        return state.bytes();
    }

    /** Where this world runs. */
    public synchronized ComputeDevice device() {
        requireUsable();
        return device;
    }

    /**
     * Waits for the device and releases everything the world holds. In the background, waits for the step that is under way, drops those
     * that have not begun, and ends the thread; logs a failure that no call has thrown yet. A second call does nothing.
     */
    @Override
    public synchronized void close() {
        if (!closed) {
            closed = true;
            leak.closed();
            state.close();
        }
    }

    private void requireUsable() {
        if (closed) {
            throw new IllegalStateException("this world is closed");
        }
        state.requireUsable();
    }
}
