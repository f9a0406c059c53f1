package io.github.circles2d;

import io.github.circles2d.pipeline.Device;
import io.github.circles2d.pipeline.Tuning;

/** Opens to tests of other packages what this package keeps to itself. */
public final class Internals {
    private Internals() {}

    public static ComputeDevice computeDevice(Device device) {
        return new ComputeDevice(device);
    }

    /**
     * A builder with the knobs of {@link WorldBuilder} that users do not have.
     *
     * @param workGroup work-items of a group, 0 for what suits the device
     * @param pairsPerSlice 0 for what the device allows
     * @param smallWorld largest world that one work-group resolves, circles; with fewer than {@link Tuning#SMALL_WORLD}, small worlds have many tiles, as
     *     large ones do
     */
    public static Circles2D.Builder builder(int workGroup, long pairsPerSlice, int smallWorld) {
        return new WorldBuilder()
                .workGroup(workGroup)
                .pairsPerSlice(pairsPerSlice)
                .oneTile(smallWorld < Tuning.SMALL_WORLD ? 0 : Tuning.ALONE_CIRCLES)
                .smallWorld(smallWorld);
    }

    /** A builder for the thesis' world: {@link Solver#IMPULSE}, by pairs. */
    public static Circles2D.Builder thesis() {
        return thesisBuilder();
    }

    static WorldBuilder thesisBuilder() {
        return new WorldBuilder().solver(Solver.IMPULSE).indexStrategy(IndexStrategy.folded());
    }

    /** As {@link #builder}, of the thesis' world. */
    public static Circles2D.Builder thesis(int workGroup, long pairsPerSlice, int smallWorld) {
        return builder(workGroup, pairsPerSlice, smallWorld)
                .solver(Solver.IMPULSE)
                .indexStrategy(IndexStrategy.folded());
    }
}
