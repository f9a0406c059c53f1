package io.github.circles2d.bench;

import io.github.circles2d.Circles2D;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Snapshot;
import io.github.circles2d.Solver;
import io.github.circles2d.StepStats;
import io.github.circles2d.bench.peers.Standing;
import io.github.circles2d.demo.Scene;

/**
 * How well a scene stands after some steps, one row in Markdown: contacts that overlap; mean and largest overlap as fractions of
 * R, the largest radius (of {@code mixed}, that of the small circles), and of the smaller radius; kinetic energy in units of the
 * sum of m g R; the height below which 99 % of the centres lie; circles outside; bytes of the device a circle; milliseconds a
 * step on the way there and over the last tenth of it; the state hash.
 *
 * <pre>{@code
 * java -jar target/benchmarks.jar Quality DEVICE SCENE CIRCLES SUBSTEPS STEPS
 * }</pre>
 */
public final class Quality {
    private Quality() {}

    /** Takes the five arguments of the class comment; substeps 0 lets the world choose. */
    public static void main(String[] args) {
        ComputeDevice device = ComputeDevice.find(args[0]).orElseThrow();
        Scene scene = Scene.named(args[1]);
        int circles = Integer.parseInt(args[2]);
        int substeps = Integer.parseInt(args[3]);
        int steps = Integer.parseInt(args[4]);
        Circles2D.Builder builder = Circles2D.builder()
                .device(device)
                .solver(Solver.SMALL_STEPS)
                .indexStrategy(IndexStrategy.grid())
                .substeps(substeps);
        try (Circles2D world = scene.build(builder, circles)) {
            int timed = Math.max(1, steps / 10);
            long start = System.nanoTime();
            world.step(steps - timed);
            world.snapshot();
            double before = (System.nanoTime() - start) / 1e6 / Math.max(1, steps - timed);
            start = System.nanoTime();
            world.step(timed);
            Snapshot now = world.snapshot();
            double after = (System.nanoTime() - start) / 1e6 / timed;
            StepStats stats = world.stats();
            int n = now.count();
            float[] x = new float[n];
            float[] y = new float[n];
            float[] radius = new float[n];
            float[] mass = new float[n];
            double largest = 0;
            double masses = 0;
            for (int i = 0; i < n; i++) {
                x[i] = now.x(i);
                y[i] = now.y(i);
                radius[i] = now.radius(i);
                mass[i] = now.mass(i);
                largest = Math.max(largest, radius[i]);
                masses += mass[i];
            }
            double unit = scene == Scene.MIXED ? largest / 8 : largest;
            double g = Math.hypot(scene.gravityX(), scene.gravityY());
            float[] still = new float[n];
            Standing standing = Standing.of(x, y, still, still, radius, mass, g, unit);
            System.out.printf(
                    "| %s | %s | %,d | %s | %d | %d | %.4f | %.3f | %.4f | %.3f | %.1e | %.4f | %d | %.0f | %.3f | %.3f | %016x |%n",
                    device.name(),
                    scene.name(),
                    circles,
                    substeps == 0 ? "auto" : substeps,
                    steps,
                    stats.contacts(),
                    standing.meanOverlap(),
                    standing.maxOverlap(),
                    stats.meanOverlap(),
                    stats.maxOverlap(),
                    g > 0 ? stats.kineticEnergy() / (masses * g * unit) : stats.kineticEnergy(),
                    standing.height(),
                    stats.outside(),
                    (double) world.deviceMemory() / circles,
                    before,
                    after,
                    world.stateHash());
        }
    }
}
