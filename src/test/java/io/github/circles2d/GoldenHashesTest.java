package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;

import io.github.circles2d.demo.Scene;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * One answer on every device and every machine: each scene under {@link Solver#SMALL_STEPS} ends in the bits that
 * {@code golden-hashes.txt} says. They change with the solver, its tuning and the scenes alone. After such a change
 *
 * <pre>{@code
 * mvn -q -Pbench package && java -cp target/benchmarks.jar io.github.circles2d.bench.Hashes golden host > src/test/resources/golden-hashes.txt
 * }</pre>
 *
 * <p>writes new ones.
 */
class GoldenHashesTest {
    private static final int[] WORK_GROUPS = {1, 7, 64, 256};

    /** What a scene ends in. */
    private record Golden(String scene, int circles, int steps, String hash) {
        void check(WorldBuilder builder) {
            builder.solver(Solver.SMALL_STEPS).indexStrategy(IndexStrategy.grid());
            try (Circles2D world = Scene.named(scene).build(builder, circles)) {
                world.step(steps);
                assertEquals(hash, String.format("%016x", world.stateHash()));
            }
        }

        @Override
        public String toString() {
            return String.format("%s, %,d circles, %d steps", scene, circles, steps);
        }
    }

    private static List<Golden> all() {
        try (BufferedReader file = new BufferedReader(new InputStreamReader(
                GoldenHashesTest.class.getResourceAsStream("/golden-hashes.txt"), StandardCharsets.US_ASCII))) {
            return file.lines()
                    .filter(line -> !line.startsWith("#"))
                    .map(line -> line.split(" "))
                    .map(row -> new Golden(row[0], Integer.parseInt(row[1]), Integer.parseInt(row[2]), row[3]))
                    .toList();
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    static List<Arguments> onBothDevices() {
        List<Arguments> all = new ArrayList<>();
        all().forEach(golden -> TestDevices.both().forEach(device -> all.add(Arguments.of(golden, device))));
        return all;
    }

    @ParameterizedTest
    @MethodSource("onBothDevices")
    void everySceneEndsInTheSameBits(Golden golden, Supplier<ComputeDevice> device) {
        golden.check(new WorldBuilder().device(device.get()));
    }

    static List<Golden> small() {
        return all().stream().filter(golden -> golden.circles < 1000).toList();
    }

    /** With one launch of one group where a world is that small, and with a launch for every colour. */
    @ParameterizedTest
    @MethodSource("small")
    void workGroups(Golden golden) {
        for (int group : WORK_GROUPS) {
            for (int smallWorld : new int[] {0, 4096}) {
                golden.check(new WorldBuilder()
                        .device(TestDevices.openCl())
                        .workGroup(group)
                        .smallWorld(smallWorld));
            }
        }
    }

    @Test
    void everySceneIsThereAtFiveThousandCirclesAndSixHundredSteps() {
        Set<String> scenes = new HashSet<>();
        for (Golden golden : all()) {
            if (golden.circles == 5000 && golden.steps == 600) {
                scenes.add(golden.scene);
            }
        }
        assertEquals(Set.copyOf(Scene.ALL.stream().map(Scene::name).toList()), scenes);
    }
}
