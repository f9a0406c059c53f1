package io.github.circles2d.bench;

import io.github.circles2d.Circles2D;
import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import io.github.circles2d.demo.Scene;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;

/**
 * One answer on every device. Without arguments: the state hash of the thesis' scene and solver for each strategy, store and
 * device of this machine, as a table in Markdown; ends with status 1 where two differ. With {@code golden} and a device: the state
 * hashes of every scene under small steps, as the file that the tests compare with. From the root of the project
 *
 * <pre>{@code
 * mvn -q -Pbench package
 * java -cp target/benchmarks.jar io.github.circles2d.bench.Hashes
 * java -cp target/benchmarks.jar io.github.circles2d.bench.Hashes golden gpu | diff src/test/resources/golden-hashes.txt -
 * java -cp target/benchmarks.jar io.github.circles2d.bench.Hashes golden host > src/test/resources/golden-hashes.txt
 * }</pre>
 *
 * <p>prints the table, compares a GPU with the golden values, and makes new ones after a change of the solver or of a scene.
 */
public final class Hashes {
    private static final int CIRCLES = 1000;
    private static final int STEPS = 300;

    /** Circles and steps of the golden values: those of the promise, and few enough to try many devices and groups. */
    private static final int[][] GOLDEN = {{5000, 600}, {300, 120}};

    private Hashes() {}

    /** Takes no arguments, or the two of the class comment. */
    public static void main(String[] args) {
        if (args.length == 0) {
            table();
        } else if (args.length == 2 && args[0].equals("golden")) {
            golden(ComputeDevice.find(args[1]).orElseThrow());
        } else {
            System.err.println("no arguments, or: golden DEVICE");
            System.exit(2);
        }
    }

    private static void golden(ComputeDevice device) {
        System.out.println(
                "# State hashes under Solver.SMALL_STEPS with IndexStrategy.grid() and substeps that the world chooses.");
        System.out.println(
                "# Written by io.github.circles2d.bench.Hashes, which says how. Scene, circles, steps, hash:");
        for (int[] size : GOLDEN) {
            for (Scene scene : Scene.ALL) {
                Circles2D.Builder builder = Circles2D.builder()
                        .device(device)
                        .solver(Solver.SMALL_STEPS)
                        .indexStrategy(IndexStrategy.grid());
                long start = System.nanoTime();
                try (Circles2D world = scene.build(builder, size[0])) {
                    world.step(size[1]);
                    System.out.printf("%s %d %d %016x%n", scene.name(), size[0], size[1], world.stateHash());
                }
                double seconds = (System.nanoTime() - start) / 1e9;
                System.err.printf(Locale.ROOT, "%s, %d circles: %.1f s%n", scene.name(), size[0], seconds);
            }
        }
    }

    private static void table() {
        Set<Long> seen = new HashSet<>();
        System.out.printf(
                "%,d circles, %d steps%n%n| device | strategy | store | state hash |%n| --- | --- | --- | --- |%n",
                CIRCLES, STEPS);
        for (ComputeDevice device : ComputeDevice.list()) {
            for (IndexStrategy strategy : IndexStrategy.builtIn()) {
                for (CollisionStore store : CollisionStore.values()) {
                    // the solver for which strategies and stores make the most difference
                    Circles2D.Builder builder = Circles2D.builder()
                            .device(device)
                            .solver(Solver.IMPULSE)
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
