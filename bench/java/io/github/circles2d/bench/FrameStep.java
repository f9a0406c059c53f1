package io.github.circles2d.bench;

import com.sun.management.ThreadMXBean;
import io.github.circles2d.Circles2D;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Snapshot;
import io.github.circles2d.Solver;
import java.lang.management.ManagementFactory;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.AuxCounters;
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
 * A frame of a game: {@code step()}, {@code work} milliseconds of something else, {@code snapshot()}; a pile that lies ready
 * ({@link Layout#packed}), grid, small steps. At 8 substeps one of more than some 20,000 circles sinks while it is measured. The counters {@code stepNanos} and {@code snapshotNanos} over {@code frames} are what the game's thread waits in each.
 *
 * <pre>{@code
 * mvn -q -Pbench verify -Dbench.args="FrameStep -p circles=1000,100000 -p device=gpu -prof gc"
 * }</pre>
 *
 * <p>{@link Frame} makes a table of it.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 2, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class FrameStep {
    private static final int SETTLE = 10;

    /**
     * Frames before the first that is measured, and the time that they may take: compilers take some memory once on the thread that runs
     * what they compile.
     */
    private static final int FRAMES_BEFORE = 400;

    private static final long NANOS_BEFORE = 2_000_000_000L;
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    /** As {@link io.github.circles2d.ComputeDevice#find} takes it, or {@code preferred}. */
    @Param("preferred")
    public String device;

    @Param({"1000", "10000", "100000", "1000000"})
    public int circles;

    /** What else the game's thread does between the two calls, milliseconds; it keeps its core busy. */
    @Param({"0", "1", "4", "10"})
    public int work;

    /** Substeps a step; 0 lets the world choose. */
    @Param("8")
    public int substeps;

    /** Circles whose velocity the game sets before the step, to 0, all over the world and others in each frame. */
    @Param("0")
    public int kicks;

    /** Whether the world has a thread of its own for its steps. */
    @Param({"false", "true"})
    public boolean background;

    private Circles2D world;

    /** Sums over an iteration. */
    @State(Scope.Thread)
    @AuxCounters(AuxCounters.Type.EVENTS)
    public static class Sums {
        public long frames;
        public long stepNanos;
        public long snapshotNanos;
        /** Bytes that the game's thread takes from the heap in the two calls. */
        public long heapBytes;
    }

    @Setup
    public void build() {
        world = Layout.packed(circles)
                .world(Circles2D.builder()
                        .device(Machine.device(device))
                        .solver(Solver.SMALL_STEPS)
                        .indexStrategy(IndexStrategy.grid())
                        .substeps(substeps)
                        .background(background));
        world.step(SETTLE);
        world.snapshot();
        long end = System.nanoTime() + NANOS_BEFORE;
        for (int frame = 0; frame < FRAMES_BEFORE && System.nanoTime() < end; frame++) {
            world.step();
            world.snapshot();
        }
    }

    @TearDown
    public void close() {
        world.close();
    }

    @Benchmark
    public Snapshot frame(Sums sums) {
        long heap = THREADS.getCurrentThreadAllocatedBytes();
        for (int k = 0; k < kicks; k++) {
            world.setVelocity((int) ((7919L * k + sums.frames) % circles), 0, 0);
        }
        long start = System.nanoTime();
        world.step();
        long stepped = System.nanoTime();
        if (work > 0) {
            long end = stepped + work * 1_000_000L;
            while (System.nanoTime() < end) {
                Thread.onSpinWait();
            }
        }
        long before = System.nanoTime();
        Snapshot now = world.snapshot();
        long after = System.nanoTime();
        sums.heapBytes += THREADS.getCurrentThreadAllocatedBytes() - heap;
        sums.frames++;
        sums.stepNanos += stepped - start;
        sums.snapshotNanos += after - before;
        return now;
    }
}
