package io.github.circles2d.bench;

import io.github.circles2d.Circles2D;
import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Snapshot;
import io.github.circles2d.demo.Scene;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * One step of the thesis' test program, read-back included: update, detect, colour, resolve, and a snapshot, as the thesis
 * times its {@code simulate}.
 *
 * <pre>{@code
 * mvn -q -Pbench verify -Dbench.args="ThesisStep -p device=gpu,cpu,host -p circles=1250,15000"
 * }</pre>
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 2, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class ThesisStep {
    /** As {@link ComputeDevice#find} takes it, or {@code preferred}. */
    @Param("preferred")
    public String device;

    @Param({"formula", "pair_table", "row_search", "folded"})
    public String strategy;

    @Param({"COMPACT", "TRIANGLE"})
    public CollisionStore store;

    @Param({"1250", "2500", "5000", "10000", "15000"})
    public int circles;

    private Circles2D world;

    @Setup
    public void build() {
        ComputeDevice on = device.equals("preferred")
                ? ComputeDevice.preferred()
                : ComputeDevice.find(device)
                        .orElseThrow(() -> new IllegalArgumentException(
                                "device = " + device + ": there are " + ComputeDevice.list()));
        System.out.print(on + " ");
        world = Scene.THESIS.build(
                Circles2D.builder()
                        .device(on)
                        .indexStrategy(IndexStrategy.named(strategy))
                        .collisionStore(store),
                circles);
        world.step();
    }

    @TearDown
    public void close() {
        world.close();
    }

    @Benchmark
    public Snapshot step() {
        world.step();
        return world.snapshot();
    }
}
