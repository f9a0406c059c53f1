package io.github.circles2d.bench;

import io.github.circles2d.CircleDef;
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
 * energy in units of the sum of m g r, the height below which 99 % of the centres lie, circles outside, milliseconds a step on
 * the way there and over the last tenth of it, and, from there on, at 8 substeps; the state hash.
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
            double g = Math.hypot(scene.gravityX(), scene.gravityY());
            double weight = 0;
            float[] heights = new float[now.count()];
            for (int i = 0; i < now.count(); i++) {
                weight += now.mass(i) * g * now.radius(i);
                heights[i] = now.y(i);
            }
            Arrays.sort(heights);
            double eight = eight(scene, device, now);
            System.out.printf(
                    "| %s | %s | %,d | %s | %d | %d | %.4f | %.3f | %.1e | %.4f | %d | %.3f | %.3f | %.3f | %016x |%n",
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
                    eight,
                    world.stateHash());
        }
    }

    /** Milliseconds a step of 8 substeps for the circles as they lie. */
    private static double eight(Scene scene, ComputeDevice device, Snapshot now) {
        Circles2D.Builder builder = Circles2D.builder()
                .device(device)
                .solver(Solver.SMALL_STEPS)
                .indexStrategy(IndexStrategy.grid())
                .substeps(8);
        try (Circles2D world = scene.empty(builder, now.count())) {
            CircleDef def = new CircleDef();
            for (int i = 0; i < now.count(); i++) {
                def.position(now.x(i), now.y(i)).radius(now.radius(i)).mass(now.mass(i));
                world.addCircle(def.velocity(now.vx(i), now.vy(i)));
            }
            world.step(5);
            world.snapshot();
            long start = System.nanoTime();
            world.step(20);
            world.snapshot();
            return (System.nanoTime() - start) / 1e6 / 20;
        }
    }
}
