package io.github.circles2d;

import io.github.circles2d.pipeline.DeviceState;
import io.github.circles2d.pipeline.Pipeline;
import io.github.circles2d.pipeline.SmallPipeline;
import io.github.circles2d.pipeline.SmallStages;
import io.github.circles2d.pipeline.Stages;
import io.github.circles2d.pipeline.StepSums;
import io.github.circles2d.pipeline.Stepper;
import io.github.circles2d.pipeline.Tuning;
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
 * no particular order. Worlds share nothing: each thread can have its own.
 *
 * <p><b>Errors.</b> When a device fails in a step the call throws a {@link Circles2DException} and the world has failed:
 * every later call but {@link #close()} throws again, with the first failure as its cause. A {@link Snapshot} taken
 * before stays readable. After {@link #close()} every call throws {@link IllegalStateException}.
 */
public final class Circles2D implements AutoCloseable {
    private final ComputeDevice device;
    private final WorldConfig config;
    private final DeviceState stages;
    private final Stepper pipeline;
    private final CircleState state;
    private final LeakReporter leak;

    /** The state on the host is that of the last step. */
    private boolean fresh = true;
    /** The state on the host has changes that the device has not seen. */
    private boolean changed = true;

    /** An upload has failed half-way: what the device holds is neither the old state nor the new. */
    private boolean lost;

    private long steps;
    /** Of step number {@code stats.steps()}. */
    private StepStats stats = new StepStats(0, 0, 0, 0, 0, 0, 0, 0, 0);

    private boolean closed;
    private Circles2DException failure;

    Circles2D(ComputeDevice device, WorldConfig config, int capacity) {
        this.device = device;
        this.config = config;
        state = new CircleState(capacity);
        if (config.solver() == Solver.SMALL_STEPS) {
            SmallStages small = device.device().openSmall(config);
            stages = small;
            pipeline = new SmallPipeline(config, small);
        } else {
            Stages opened = device.device().open(config);
            stages = opened;
            pipeline = new Pipeline(opened);
        }
        leak = LeakReporter.watch(this, device.toString());
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
        Check.range("x", x, config.minX(), config.maxX());
        Check.range("y", y, config.minY(), config.maxY());
        Check.range("radius", radius, Tuning.MIN_RADIUS, Tuning.MAX_RADIUS);
        Check.range("mass", mass, Tuning.MIN_MASS, Tuning.MAX_MASS);
        Check.magnitude("vx", vx, Tuning.MAX_SPEED);
        Check.magnitude("vy", vy, Tuning.MAX_SPEED);
        // as the kernels compute it: a circle fits if its centre has somewhere to be
        if (config.minX() + radius > config.maxX() - radius || config.minY() + radius > config.maxY() - radius) {
            throw new IllegalArgumentException("radius = " + radius + ": the circle must fit into the bounds, "
                    + (config.maxX() - config.minX()) + " x " + (config.maxY() - config.minY()));
        }
        download();
        int slot = state.add(x, y, radius, mass, vx, vy);
        changed = true;
        return state.circleAt(slot);
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
        if (circle < 0 || circle >= state.count()) {
            throw new IllegalArgumentException(
                    "circle = " + circle + ": not a handle of this world, which has " + state.count() + " circles");
        }
        Check.magnitude("vx", vx, Tuning.MAX_SPEED);
        Check.magnitude("vy", vy, Tuning.MAX_SPEED);
        download();
        state.setVelocity((int) circle, vx, vy);
        changed = true;
    }

    /** Number of circles. */
    public synchronized int circleCount() {
        requireUsable();
        return state.count();
    }

    /** One time step. Queues the work and need not wait for it. */
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
        if (count == 0) {
            return;
        }
        upload();
        fresh = false;
        try {
            for (int i = 0; i < count; i++) {
                pipeline.step();
            }
        } catch (Circles2DException e) {
            throw failed(e);
        }
        steps += count;
    }

    /** The circles after the last step. Waits for it. Always the same object, refreshed. */
    public synchronized Snapshot snapshot() {
        requireUsable();
        download();
        return state;
    }

    /**
     * A hash of the raw bits of every circle's centre, radius, mass and velocity, in the order the circles were added in.
     * The same calls give the same hash on every deterministic device. Waits for the last step.
     */
    public synchronized long stateHash() {
        requireUsable();
        download();
        return state.hash();
    }

    /** What the last step looked like; before the first, the circles alone. Waits for it; computed on the device. */
    public synchronized StepStats stats() {
        requireUsable();
        if (steps > 0 && stats.steps() == steps) {
            return stats;
        }
        if (steps == 0 || lost) {
            upload();
        }
        try {
            pipeline.await();
            StepSums sums = stages.sums();
            stats = new StepStats(
                    steps,
                    sums.touching(),
                    sums.largestOverlap(),
                    sums.meanOverlap(),
                    sums.energy(),
                    sums.momentumX(),
                    sums.momentumY(),
                    sums.fastest(),
                    (int) sums.outside());
            return stats;
        } catch (Circles2DException e) {
            throw failed(e);
        }
    }

    /**
     * How much of its device's memory the world holds now, bytes, tables of the index strategy included: under {@link
     * Solver#SMALL_STEPS} with {@link IndexStrategy#grid()} some 200 a circle. 0 before the first step and on the host
     * device, whose memory is Java's heap.
     */
    public synchronized long deviceMemory() {
        requireUsable();
        return stages.bytes();
    }

    /** Where this world runs. */
    public synchronized ComputeDevice device() {
        requireUsable();
        return device;
    }

    /** Waits for the device and releases everything the world holds. A second call does nothing. */
    @Override
    public synchronized void close() {
        if (!closed) {
            closed = true;
            leak.closed();
            stages.close();
        }
    }

    private void upload() {
        if (changed) {
            lost = true;
            pipeline.upload(state.circleBuffer(), state.velocityBuffer(), state.count(), state.maxRadius());
            lost = false;
            changed = false;
        }
    }

    private void download() {
        if (fresh) {
            return;
        }
        try {
            pipeline.await();
            stages.download(state.circleBuffer(), state.velocityBuffer());
        } catch (Circles2DException e) {
            throw failed(e);
        }
        state.refreshed();
        fresh = true;
    }

    private Circles2DException failed(Circles2DException e) {
        failure = e;
        return e;
    }

    private void requireUsable() {
        if (closed) {
            throw new IllegalStateException("this world is closed");
        }
        if (failure != null) {
            throw new Circles2DException("this world has failed: " + failure.getMessage(), failure);
        }
    }
}
