package io.github.circles2d.bench.peers;

/**
 * A physics engine with the scene {@code pile} in it: circles without friction in a box, one step is 1/60 s. What it reads out is in the
 * units of the scene, whatever it computes in.
 */
public interface Engine extends AutoCloseable {
    /** One step, done when it returns. */
    void step();

    /** Centres and velocities of all circles, in the order of the scene, in world units and world units a second. */
    void read(float[] x, float[] y, float[] vx, float[] vy);

    @Override
    void close();
}
