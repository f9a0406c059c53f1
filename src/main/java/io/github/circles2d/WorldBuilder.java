package io.github.circles2d;

import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;

/** The builder behind {@link Circles2D#builder()}; what is package-private here is for tests. */
final class WorldBuilder implements Circles2D.Builder {
    private ComputeDevice device;
    private IndexStrategy strategy = IndexStrategy.grid();
    private CollisionStore store = CollisionStore.COMPACT;
    private Solver solver = Solver.SMALL_STEPS;
    private int substeps;
    private float timeStep = 1f / 60;
    private float gravityX;
    private float gravityY = -1;
    private float restitution = 0.5f;
    private float minX;
    private float minY;
    private float maxX = 1;
    private float maxY = 1;
    private int capacity = Tuning.FIRST_CIRCLES;
    private boolean background;
    private int workGroup;
    private long pairsPerSlice;
    private int smallWorld = Tuning.SMALL_WORLD;
    private int oneTile = Tuning.ALONE_CIRCLES;

    @Override
    public WorldBuilder device(ComputeDevice device) {
        this.device = Check.given("device", device);
        return this;
    }

    @Override
    public WorldBuilder indexStrategy(IndexStrategy strategy) {
        this.strategy = Check.given("strategy", strategy);
        return this;
    }

    @Override
    public WorldBuilder collisionStore(CollisionStore store) {
        this.store = Check.given("store", store);
        return this;
    }

    @Override
    public WorldBuilder solver(Solver solver) {
        this.solver = Check.given("solver", solver);
        return this;
    }

    @Override
    public WorldBuilder timeStep(float seconds) {
        timeStep = Check.range("timeStep", seconds, Tuning.MIN_TIME_STEP, Tuning.MAX_TIME_STEP);
        return this;
    }

    @Override
    public WorldBuilder substeps(int count) {
        substeps = Check.range("substeps", count, 0, Tuning.MAX_SUBSTEPS);
        return this;
    }

    @Override
    public WorldBuilder gravity(float ax, float ay) {
        Check.magnitude("gravity ax", ax, Tuning.MAX_GRAVITY);
        Check.magnitude("gravity ay", ay, Tuning.MAX_GRAVITY);
        gravityX = ax;
        gravityY = ay;
        return this;
    }

    @Override
    public WorldBuilder restitution(float e) {
        restitution = Check.range("restitution", e, 0, 1);
        return this;
    }

    @Override
    public WorldBuilder bounds(float minX, float minY, float maxX, float maxY) {
        Check.magnitude("bounds minX", minX, Tuning.MAX_COORDINATE);
        Check.magnitude("bounds minY", minY, Tuning.MAX_COORDINATE);
        Check.magnitude("bounds maxX", maxX, Tuning.MAX_COORDINATE);
        Check.magnitude("bounds maxY", maxY, Tuning.MAX_COORDINATE);
        if (!(minX < maxX && minY < maxY)) {
            throw new IllegalArgumentException("bounds = (" + minX + ", " + minY + ") to (" + maxX + ", " + maxY
                    + "): each minimum must be below its maximum");
        }
        this.minX = minX;
        this.minY = minY;
        this.maxX = maxX;
        this.maxY = maxY;
        return this;
    }

    @Override
    public WorldBuilder capacity(int circles) {
        capacity = Check.range("capacity", circles, 0, Tuning.MAX_CIRCLES);
        return this;
    }

    @Override
    public WorldBuilder background(boolean background) {
        this.background = background;
        return this;
    }

    /** Work-items of a group, a power of two; 0 for what suits the device. */
    WorldBuilder workGroup(int items) {
        workGroup = items;
        return this;
    }

    /** Most pairs of one slice; 0 for what the device allows. */
    WorldBuilder pairsPerSlice(long pairs) {
        pairsPerSlice = pairs;
        return this;
    }

    /** Largest world that one work-group colours and resolves, circles. */
    WorldBuilder smallWorld(int circles) {
        smallWorld = circles;
        return this;
    }

    /** Largest world of one tile, circles. Worlds that differ in it do not end in the same bits. */
    WorldBuilder oneTile(int circles) {
        oneTile = circles;
        return this;
    }

    @Override
    public Circles2D build() {
        ComputeDevice on = device != null ? device : ComputeDevice.preferred();
        if (strategy != IndexStrategy.auto()) {
            return new Circles2D(on, config(strategy, smallWorld), capacity, background);
        }
        AutoChoice choice = AutoChoice.of(on, solver, store, capacity);
        return new Circles2D(on, config(choice.strategy(), choice.smallWorld()), capacity, background);
    }

    private WorldConfig config(IndexStrategy chosen, int largestSmallWorld) {
        return new WorldConfig(
                timeStep,
                gravityX,
                gravityY,
                restitution,
                minX,
                minY,
                maxX,
                maxY,
                chosen,
                store,
                solver,
                workGroup,
                pairsPerSlice,
                largestSmallWorld,
                oneTile,
                substeps);
    }
}
