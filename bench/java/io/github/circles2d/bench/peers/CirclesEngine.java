package io.github.circles2d.bench.peers;

import io.github.circles2d.Circles2D;
import io.github.circles2d.Snapshot;

/** Circles2D; a step waits for its end and reads all circles back. */
public final class CirclesEngine implements Engine {
    private final Circles2D world;

    /** Takes a world, which is closed with this. */
    public CirclesEngine(Circles2D world) {
        this.world = world;
    }

    @Override
    public void step() {
        world.step();
        world.snapshot();
    }

    @Override
    public void read(float[] x, float[] y, float[] vx, float[] vy) {
        Snapshot now = world.snapshot();
        for (int i = 0; i < now.count(); i++) {
            x[i] = now.x(i);
            y[i] = now.y(i);
            vx[i] = now.vx(i);
            vy[i] = now.vy(i);
        }
    }

    @Override
    public void close() {
        world.close();
    }
}
