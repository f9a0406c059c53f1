package io.github.circles2d.bench;

import io.github.circles2d.Circles2D;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Snapshot;
import io.github.circles2d.Solver;
import io.github.circles2d.StepStats;
import io.github.circles2d.demo.Scene;
import java.util.Arrays;

/**
 * How well a scene stands after some steps, one row in Markdown: overlaps as fractions of the smaller radius, kinetic
 * energy a circle in units of m g r (r the mean radius), the height below which 99 % of the centres lie, and the time of a
 * step over the last tenth of them.
 *
 * <pre>{@code
 * java -cp target/benchmarks.jar io.github.circles2d.bench.Quality DEVICE SCENE CIRCLES SUBSTEPS STEPS
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
            double g = Math.hypot(scene.gravityX(), scene.gravityY());
            double weight = 0;
            float[] heights = new float[now.count()];
            for (int i = 0; i < now.count(); i++) {
                weight += now.mass(i) * g * now.radius(i);
                heights[i] = now.y(i);
            }
            Arrays.sort(heights);
            System.out.printf(
                    "| %s | %s | %,d | %s | %d | %d | %.4f | %.3f | %.1e | %.4f | %d | %.3f | %.3f | %016x |%n",
                    device.name(),
                    scene.name(),
                    circles,
                    substeps == 0 ? "auto" : substeps,
                    steps,
                    stats.contacts(),
                    stats.meanOverlap(),
                    stats.maxOverlap(),
                    weight > 0 ? stats.kineticEnergy() / weight : stats.kineticEnergy(),
                    heights.length > 0 ? heights[(int) (0.99 * (heights.length - 1))] : 0,
                    stats.outside(),
                    before,
                    after,
                    world.stateHash());
        }
    }
}
