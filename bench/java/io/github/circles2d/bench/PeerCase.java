package io.github.circles2d.bench;

import io.github.circles2d.Circles2D;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import io.github.circles2d.bench.peers.CirclesEngine;
import io.github.circles2d.bench.peers.Dyn4jEngine;
import io.github.circles2d.bench.peers.Engine;
import io.github.circles2d.bench.peers.GdxEngine;
import io.github.circles2d.bench.peers.JBox2dEngine;
import io.github.circles2d.bench.peers.Pile;
import io.github.circles2d.bench.peers.Standing;
import java.util.Arrays;

/** One row of {@link Peers}, in a JVM of its own. */
final class PeerCase {
    /** Steps of the falling phase: the first second. */
    static final int FALLING = 60;

    /** Steps before which there is no pile to time. */
    static final int PILE = 2 * FALLING;

    /** Steps that are timed at the end. */
    static final int PILED = 60;

    private static final int WARM_CIRCLES = 500;

    private PeerCase() {}

    /** Takes the engine, circles, steps and seconds. */
    public static void main(String[] args) {
        int circles = Integer.parseInt(args[1]);
        int steps = Integer.parseInt(args[2]);
        long now = System.nanoTime();
        long end = now + Long.parseLong(args[3]) * 1_000_000_000L;
        try (Engine warm = engine(args[0], Layout.start(WARM_CIRCLES))) {
            // Java is compiled when it counts: three seconds of the same with fewer circles
            long until = now + Math.min(3_000_000_000L, (end - now) / 10);
            while (System.nanoTime() < until) {
                warm.step();
            }
        }
        Layout layout = Layout.start(circles);
        try (Engine engine = engine(args[0], layout)) {
            double[] ms = new double[steps];
            int done = 0;
            while (done < steps && System.nanoTime() < end) {
                long start = System.nanoTime();
                engine.step();
                ms[done++] = (System.nanoTime() - start) / 1e6;
            }
            report(engine, layout, ms, done);
        }
    }

    private static void report(Engine engine, Layout layout, double[] ms, int done) {
        int n = layout.count();
        float[] x = new float[n];
        float[] y = new float[n];
        float[] vx = new float[n];
        float[] vy = new float[n];
        engine.read(x, y, vx, vy);
        double gravity = -Layout.SCENE.gravityY();
        Standing standing = Standing.of(x, y, vx, vy, layout.radius(), layout.mass(), gravity);
        // a pile that had no time to form has no time of its own
        int piled = Math.min(PILED, done / 5);
        Child.result(
                mean(ms, 0, Math.min(FALLING, done)),
                done >= PILE ? mean(ms, done - piled, done) : "",
                done,
                standing.contacts(),
                standing.meanOverlap(),
                standing.maxOverlap(),
                standing.energy(),
                standing.height(),
                standing.outside());
    }

    private static double mean(double[] values, int from, int to) {
        return Arrays.stream(values, from, to).average().orElse(0);
    }

    /** An engine by its name in the table: {@code dyn4j}, {@code jbox2d}, {@code libgdx}, or {@code DEVICE:SUBSTEPS} for ours. */
    private static Engine engine(String name, Layout layout) {
        if (!name.contains(":")) {
            Pile pile = Pile.of(
                    layout.x(),
                    layout.y(),
                    layout.radius(),
                    layout.mass(),
                    layout.meanRadius(),
                    -Layout.SCENE.gravityY(),
                    Layout.SCENE.restitution());
            return switch (name) {
                case "dyn4j" -> new Dyn4jEngine(pile);
                case "jbox2d" -> new JBox2dEngine(pile);
                case "libgdx" -> new GdxEngine(pile);
                default -> throw new IllegalArgumentException("engine = " + name);
            };
        }
        String[] parts = name.split(":");
        Circles2D.Builder builder = Circles2D.builder()
                .device(Machine.device(parts[0]))
                .solver(Solver.SMALL_STEPS)
                .indexStrategy(IndexStrategy.grid())
                .substeps(Integer.parseInt(parts[1]));
        return new CirclesEngine(layout.world(builder));
    }
}
