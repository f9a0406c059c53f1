package io.github.circles2d.bench;

import io.github.circles2d.Circles2D;
import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.demo.Scene;
import java.util.HashSet;
import java.util.Set;

/**
 * One answer on every device: the state hash of the thesis' scene for each strategy, store and device of this machine, as
 * a table in Markdown. Ends with status 1 where two differ.
 *
 * <pre>{@code
 * java -cp target/benchmarks.jar io.github.circles2d.bench.Hashes
 * }</pre>
 */
public final class Hashes {
    private static final int CIRCLES = 1000;
    private static final int STEPS = 300;

    private Hashes() {}

    /** Takes no arguments. */
    public static void main(String[] args) {
        Set<Long> seen = new HashSet<>();
        System.out.printf(
                "%,d circles, %d steps%n%n| device | strategy | store | state hash |%n| --- | --- | --- | --- |%n",
                CIRCLES, STEPS);
        for (ComputeDevice device : ComputeDevice.list()) {
            for (IndexStrategy strategy : IndexStrategy.builtIn()) {
                for (CollisionStore store : CollisionStore.values()) {
                    Circles2D.Builder builder = Circles2D.builder()
                            .device(device)
                            .indexStrategy(strategy)
                            .collisionStore(store);
                    try (Circles2D world = Scene.THESIS.build(builder, CIRCLES)) {
                        world.step(STEPS);
                        seen.add(world.stateHash());
                        System.out.printf(
                                "| %s | %s | %s | %016x |%n", device.name(), strategy.name(), store, world.stateHash());
                    }
                }
            }
        }
        System.out.println(seen.size() == 1 ? "\none hash" : "\n" + seen.size() + " DIFFERENT hashes");
        if (seen.size() != 1) {
            System.exit(1);
        }
    }
}
