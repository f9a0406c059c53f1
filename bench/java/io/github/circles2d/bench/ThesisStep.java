package io.github.circles2d.bench;

import io.github.circles2d.CircleDef;
import io.github.circles2d.Circles2D;
import io.github.circles2d.CollisionStore;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Snapshot;
import io.github.circles2d.Solver;
import io.github.circles2d.demo.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * One step of the thesis' test program, read-back included: update, detect, colour, resolve, and a snapshot, as the thesis
 * times its {@code simulate} over 1,000 steps; here {@value #STEPS} steps from the start, where circles lie scattered, and
 * as many after 900 steps, where they lie in a heap and contacts are many.
 *
 * <pre>{@code
 * mvn -q -Pbench verify -Dbench.args="ThesisStep -p device=gpu,cpu,host -p circles=1250,15000"
 * }</pre>
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 2)
@Measurement(iterations = 5)
@Fork(1)
public class ThesisStep {
    static final int STEPS = 100;

    /** As {@link io.github.circles2d.ComputeDevice#find} takes it, or {@code preferred}. */
    @Param("preferred")
    public String device;

    @Param({"formula", "pair_table", "row_search", "folded"})
    public String strategy;

    @Param({"COMPACT", "TRIANGLE"})
    public CollisionStore store;

    @Param({"0", "900"})
    public int from;

    @Param({"1250", "2500", "5000", "10000", "15000"})
    public int circles;

    private final List<CircleDef> start = new ArrayList<>();
    private Circles2D world;

    /** The circles after {@code from} steps, which the fastest device takes in the fastest way: all give the same. */
    @Setup
    public void prepare() {
        try (Circles2D first = Scene.THESIS.build(
                Circles2D.builder().solver(Solver.IMPULSE).indexStrategy(IndexStrategy.grid()), circles)) {
            first.step(from);
            Snapshot now = first.snapshot();
            for (int i = 0; i < circles; i++) {
                start.add(new CircleDef()
                        .position(now.x(i), now.y(i))
                        .radius(now.radius(i))
                        .mass(now.mass(i))
                        .velocity(now.vx(i), now.vy(i)));
            }
        }
    }

    @Setup(Level.Iteration)
    public void build() {
        world = Scene.THESIS.empty(
                Circles2D.builder()
                        .device(Machine.device(device))
                        .solver(Solver.IMPULSE)
                        .indexStrategy(IndexStrategy.named(strategy))
                        .collisionStore(store),
                circles);
        start.forEach(world::addCircle);
        world.step();
        world.snapshot();
    }

    @TearDown(Level.Iteration)
    public void close() {
        world.close();
    }

    @Benchmark
    @OperationsPerInvocation(STEPS)
    public Snapshot step() {
        for (int i = 1; i < STEPS; i++) {
            world.step();
            world.snapshot();
        }
        world.step();
        return world.snapshot();
    }
}
