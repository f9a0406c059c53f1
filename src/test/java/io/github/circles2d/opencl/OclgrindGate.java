package io.github.circles2d.opencl;

import io.github.circles2d.Circles2D;
import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Internals;
import io.github.circles2d.Solver;
import io.github.circles2d.StepStats;
import io.github.circles2d.demo.Scene;
import io.github.circles2d.pipeline.KernelSources;
import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Population;
import io.github.circles2d.pipeline.SmallSteps;
import io.github.circles2d.pipeline.Tuning;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.FloatBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Runs every kernel on Oclgrind, which checks each access of memory, and compares the results with plain Java.
 * {@code .ci/oclgrind-gate} starts it and reads Oclgrind's log. An argument names a planted fault to run instead.
 */
public final class OclgrindGate {
    private static final Pattern KERNEL = Pattern.compile("__kernel\\s+(?:C2D_ONE\\s+)?void\\s+(\\w+)");
    private static final List<IndexStrategy> STRATEGIES = List.of(
            IndexStrategy.formula(), IndexStrategy.pairTable(), IndexStrategy.rowSearch(), IndexStrategy.folded());

    private final FaultyClApi books = new FaultyClApi(JoclApi.load());
    private final OpenClDevice device;
    private int worlds;

    private OclgrindGate() {
        List<OpenClDevice> devices = OpenClDevices.list(books.api());
        require(devices.size() == 1, "one device, not " + devices.size());
        device = devices.get(0);
        require(device.platform().contains("Oclgrind"), "Oclgrind, not " + device.platform());
        System.out.println("gate: " + device.name() + ", " + device.platform());
    }

    public static void main(String[] args) {
        OclgrindGate gate = new OclgrindGate();
        if (args.length > 0) {
            PlantedFault.valueOf(args[0]).run(gate.device);
        } else {
            gate.everything();
        }
    }

    private static void require(boolean holds, String what) {
        if (!holds) {
            throw new AssertionError("gate: expected " + what);
        }
    }

    private void everything() {
        for (IndexStrategy strategy : STRATEGIES) {
            for (CollisionStore store : CollisionStore.values()) {
                // a world that one work-group resolves, and one that is resolved colour by colour
                agree(Scene.THESIS, 65, 4, strategy, store, 0, 4096);
                agree(Scene.THESIS, 65, 4, strategy, store, 0, 0);
                agree(Scene.GAS, 64, 4, strategy, store, 300, 0);
            }
            wide(strategy, CollisionStore.COMPACT);
            wide(strategy, CollisionStore.TRIANGLE);
        }
        for (int circles : new int[] {1, 2, 3, 63, 128}) {
            agree(Scene.THESIS, circles, 2, IndexStrategy.folded(), CollisionStore.COMPACT, 0, 4096);
            agree(Scene.THESIS, circles, 2, IndexStrategy.folded(), CollisionStore.COMPACT, 0, 0);
        }
        for (CollisionStore store : CollisionStore.values()) {
            agree(pile(), 52, 2, IndexStrategy.rowSearch(), store, 0, 4096);
            agree(pile(), 52, 2, IndexStrategy.rowSearch(), store, 1000, 0);
        }
        for (IndexStrategy strategy : List.of(IndexStrategy.grid(), IndexStrategy.folded())) {
            // with a launch a colour, and with one for all of them
            agreeInSmallSteps(Scene.PEBBLES, 33, strategy, 2, 0);
            agreeInSmallSteps(Scene.PEBBLES, 33, strategy, 2, 1);
            agreeInSmallSteps(Scene.PEBBLES, 33, strategy, 2, 4096);
            agreeInSmallSteps(pile(), 10, strategy, 2, 0);
        }
        // so calm that from the third step on contacts are those of the step before
        int detections = books.launches("c2d_match");
        agreeInSmallSteps(still(), 16, IndexStrategy.grid(), 2, 0, world -> world.step(4));
        agreeInSmallSteps(still(), 16, IndexStrategy.grid(), 2, 4096, world -> world.step(4));
        require(books.launches("c2d_match") - detections == 4, "two detections each");
        // contacts that only the last tiling holds
        agreeInSmallSteps(crossing(), 6, IndexStrategy.grid(), 2, 0);
        // lists more contacts than there is room for, and is sorted again
        agreeInSmallSteps(pile(), 52, IndexStrategy.grid(), 1, 1);
        // more contacts in a tile than fit into local memory, and circles of two cells by turns; by one group, too many
        // and few enough
        agreeInSmallSteps(folded(), 108, IndexStrategy.grid(), 1, 1);
        agreeInSmallSteps(folded(), 40, IndexStrategy.grid(), 1, 4096);
        agreeInSmallSteps(folded(), 12, IndexStrategy.grid(), 1, 4096);
        // by its speeds this one takes more substeps in its second step, which rescales what it remembers
        agreeInSmallSteps(Scene.GAS, 9, IndexStrategy.grid(), 0, 0);
        agree(Scene.THESIS, 65, 2, IndexStrategy.grid(), CollisionStore.COMPACT, 0, 0);
        require(device.deterministic(), "the arithmetic of plain Java");
        require(books.misuses().isEmpty() && books.live().isEmpty(), "nothing left: " + books.live() + books.misuses());
        Set<String> missing = kernels();
        require(missing.size() > 5, "kernels, found " + missing);
        missing.removeAll(books.launched());
        require(missing.isEmpty(), "every kernel to run; missing " + missing);
        System.out.println("gate: " + worlds + " worlds agree with the host; ran " + books.launched());
    }

    /** Every circle in every other: of 52, 1,326 contacts, more than such a world first has room for. */
    private static Scene pile() {
        return new Scene("pile", 0, -1, 0.5f, (world, circles) -> {
            for (int i = 0; i < circles; i++) {
                world.addCircle(0.5f + 0.0001f * i, 0.5f, 0.04f, 1 + i % 3);
            }
        });
    }

    /** Columns side by side on the floor, in which each circle overlaps the next a little. */
    private static Scene still() {
        return new Scene("still", 0, -1, 0.5f, (world, circles) -> {
            for (int i = 0; i < circles; i++) {
                world.addCircle(0.4f + 0.0395f * (i % 4), 0.0198f + 0.0395f * (i / 4), 0.02f, 1 + i % 3);
            }
        });
    }

    /** Circles on both sides of a place where borders of the first two tilings cross: 24 radii from the left, 15 from below. */
    private static Scene crossing() {
        return new Scene("crossing", 0, -1, 0.5f, (world, circles) -> {
            for (int i = 0; i < circles; i++) {
                float side = i % 2 == 0 ? -0.012f : 0.012f;
                world.addCircle(0.48f + side + 0.0001f * i, 0.30f + side, 0.02f, 1 + i % 3);
            }
        });
    }

    /** Two heaps, circle by circle, in two cells of a folded level that share a bucket. */
    private static Scene folded() {
        float radius = 0.001f;
        return new Scene("folded", 0, -1, 0.5f, (world, circles) -> {
            FloatBuffer transforms = FloatBuffer.allocate(4 * circles);
            for (int i = 0; i < circles; i++) {
                transforms.put(4 * i + 2, radius);
            }
            // the world's own cells follow from its box alone
            Levels levels = Levels.of(SmallSteps.box(1, 0), Population.of(transforms, null, circles), Tuning.REACH);
            int at = Levels.at(0);
            require(levels.folded(at), "a folded level");
            int row = 0;
            int column = 3;
            while (levels.bucket(at, column, row) != levels.bucket(at, 0, 0)) {
                row = column > 100 ? row + 1 : row;
                column = column > 100 ? 0 : column + 1;
            }
            float size = 2 * radius * (1 + Tuning.REACH);
            for (int i = 0; i < circles; i++) {
                float side = 0.5f + 0.1f * i / circles;
                float x = i % 2 == 0 ? side : side + column;
                float y = i % 2 == 0 ? side : side + row;
                world.addCircle(x * size, y * size, radius, 1 + i % 3);
            }
        });
    }

    private void agreeInSmallSteps(Scene scene, int circles, IndexStrategy strategy, int substeps, int smallWorld) {
        agreeInSmallSteps(scene, circles, strategy, substeps, smallWorld, world -> {
            world.step();
            world.setVelocity(0, 50, 3);
            world.step();
        });
    }

    private void agreeInSmallSteps(
            Scene scene, int circles, IndexStrategy strategy, int substeps, int smallWorld, Consumer<Circles2D> steps) {
        long[] hashes = new long[2];
        StepStats[] stats = new StepStats[2];
        for (int side = 0; side < 2; side++) {
            Circles2D.Builder builder = Internals.builder(32, 0, smallWorld)
                    .device(side == 0 ? ComputeDevice.host() : Internals.computeDevice(device))
                    .indexStrategy(strategy)
                    .solver(Solver.SMALL_STEPS)
                    .substeps(substeps);
            try (Circles2D world = scene.build(builder, circles)) {
                steps.accept(world);
                hashes[side] = world.stateHash();
                stats[side] = world.stats();
            }
        }
        worlds++;
        require(stats[0].equals(stats[1]), "the statistics " + stats[0] + " and not " + stats[1]);
        require(hashes[0] == hashes[1], "the hash of the host for small steps, " + scene.name() + " " + strategy);
    }

    private void agree(
            Scene scene,
            int circles,
            int steps,
            IndexStrategy strategy,
            CollisionStore store,
            long pairsPerSlice,
            int smallWorld) {
        long[] hashes = new long[2];
        StepStats[] stats = new StepStats[2];
        for (int side = 0; side < 2; side++) {
            ComputeDevice on = side == 0 ? ComputeDevice.host() : Internals.computeDevice(device);
            // many work-items in a group, so that races within one can show
            Circles2D.Builder builder = Internals.thesis(32, pairsPerSlice, smallWorld)
                    .device(on)
                    .indexStrategy(strategy)
                    .collisionStore(store);
            try (Circles2D world = scene.build(builder, circles)) {
                world.step(steps);
                hashes[side] = world.stateHash();
                stats[side] = world.stats();
            }
        }
        worlds++;
        require(stats[0].equals(stats[1]), "the statistics " + stats[0] + " and not " + stats[1]);
        require(
                hashes[0] == hashes[1],
                "the hash of the host for " + scene.name() + " " + circles + " " + strategy + " " + store
                        + " slices of " + pairsPerSlice + ", small world " + smallWorld);
    }

    private void wide(IndexStrategy strategy, CollisionStore store) {
        Set<Long> found = WideDetect.contacts(device, strategy, store, 40);
        Set<Long> expected = WideDetect.expected(40);
        require(
                found.equals(expected),
                "in 64 bits, with " + strategy + " " + store + ", " + expected + ", not " + found);
    }

    /** The kernels of {@code kernels/}, from the copy on the class path. */
    private static Set<String> kernels() {
        try {
            Path folder = Path.of(KernelSources.class
                            .getResource("/io/github/circles2d/kernels/common.cl")
                            .toURI())
                    .getParent();
            try (Stream<Path> files = Files.list(folder)) {
                Set<String> names = new TreeSet<>();
                files.map(file -> KernelSources.read(file.getFileName().toString()))
                        .forEach(source -> KERNEL.matcher(source)
                                .results()
                                .map(found -> found.group(1))
                                .forEach(names::add));
                return names;
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }
}
