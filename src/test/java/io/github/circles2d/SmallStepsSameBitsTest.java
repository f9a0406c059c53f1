package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;

import io.github.circles2d.demo.Scene;
import io.github.circles2d.pipeline.Tuning;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** {@link Solver#SMALL_STEPS} and {@link IndexStrategy#grid()}: one hash on both devices, however the work is cut. */
class SmallStepsSameBitsTest {
    private static ComputeDevice openCl;

    @BeforeAll
    static void findDevice() {
        openCl = ComputeDevice.list().get(0);
        Assumptions.assumeTrue(openCl.type() != ComputeDevice.Type.HOST, "no OpenCL device");
    }

    private static WorldBuilder builder(ComputeDevice device) {
        return new WorldBuilder()
                .device(device)
                .solver(Solver.SMALL_STEPS)
                .indexStrategy(IndexStrategy.grid())
                .substeps(8);
    }

    /** Radii over a factor of 30, masses over 100, some circles on one spot, some fast, some over a wall. */
    private static void addRandom(Circles2D world, SplittableRandom random, int count) {
        CircleDef def = new CircleDef();
        for (int i = 0; i < count; i++) {
            boolean heap = random.nextInt(8) == 0;
            def.position(heap ? 0.5f : (float) random.nextDouble(), heap ? 0.25f : (float) random.nextDouble());
            def.radius(0.002f / (0.034f + 0.966f * (float) random.nextDouble()));
            def.mass((float) Math.pow(10, random.nextDouble(-1, 1)));
            float speed = random.nextInt(10) == 0 ? 40 : 0.5f;
            def.velocity(speed * (float) random.nextDouble(-1, 1), speed * (float) random.nextDouble(-1, 1));
            world.addCircle(def);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 63, 64, 65, 1000})
    void everyStepHasTheSameBitsOnBothDevices(int circles) {
        for (int seed = 0; seed < 4; seed++) {
            int oneTile = seed % 2 == 0 ? 0 : Tuning.ALONE_CIRCLES;
            try (Circles2D host = builder(ComputeDevice.host()).oneTile(oneTile).build();
                    Circles2D device = builder(openCl)
                            .oneTile(oneTile)
                            .smallWorld(seed < 2 ? 0 : 4096)
                            .build()) {
                addRandom(host, new SplittableRandom(seed), circles);
                addRandom(device, new SplittableRandom(seed), circles);
                for (int step = 1; step <= 10; step++) {
                    host.step();
                    device.step();
                    assertEquals(host.stateHash(), device.stateHash(), "seed " + seed + ", step " + step);
                }
                assertEquals(host.stats(), device.stats());
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"pile", "pebbles"})
    void oneHashForEveryStrategyDeviceAndGroup(String scene) {
        long expected = hash(scene, ComputeDevice.host(), IndexStrategy.grid(), 0);
        for (IndexStrategy strategy : IndexStrategy.builtIn()) {
            assertEquals(expected, hash(scene, ComputeDevice.host(), strategy, 0), "host, " + strategy);
            for (int group : strategy.pairwise() ? new int[] {64} : new int[] {1, 7, 64, 256, 256}) {
                assertEquals(expected, hash(scene, openCl, strategy, group), strategy + ", groups of " + group);
            }
        }
    }

    /** A world of more circles than that is none for one work-group. */
    @ParameterizedTest
    @ValueSource(strings = {"pile", "pebbles", "bullets"})
    void oneHashForEveryWayToCutASubstep(String scene) {
        for (int oneTile : new int[] {0, Tuning.ALONE_CIRCLES}) {
            WorldBuilder host = builder(ComputeDevice.host()).oneTile(oneTile);
            long expected = hash(scene, host);
            for (int group : new int[] {1, 7, 64}) {
                for (int small : new int[] {0, 1, 4096}) {
                    WorldBuilder device = builder(openCl).oneTile(oneTile).workGroup(group);
                    assertEquals(
                            expected,
                            hash(scene, device.smallWorld(small)),
                            "groups of " + group + ", small up to " + small + ", one tile up to " + oneTile);
                }
            }
        }
    }

    private static long hash(String scene, ComputeDevice device, IndexStrategy strategy, int group) {
        // odd groups: not by one group
        return hash(
                scene,
                builder(device)
                        .workGroup(group)
                        .smallWorld(group % 2 == 0 ? 4096 : 0)
                        .indexStrategy(strategy));
    }

    private static long hash(String scene, Circles2D.Builder builder) {
        try (Circles2D world = Scene.named(scene).build(builder, 300)) {
            world.step(120);
            return world.stateHash();
        }
    }

    @Test
    void aWorldLargeEnoughForSeveralThreadsAndLaunchesHasThem() {
        Circles2D.Builder host = builder(ComputeDevice.host());
        Circles2D.Builder device = builder(openCl);
        try (Circles2D one = Scene.PILE.build(host, 12_000);
                Circles2D other = Scene.PILE.build(device, 12_000)) {
            one.step(10);
            other.step(10);
            assertEquals(one.stateHash(), other.stateHash());
        }
    }

    /** Circles then reach farther where that saves detections: here, from the fourth step on. */
    @Test
    void aWorldOfManyCirclesHasTheSameBits() {
        int many = Tuning.MANY + 1;
        try (Circles2D one = Scene.PILE.build(builder(ComputeDevice.host()).substeps(4), many);
                Circles2D other = Scene.PILE.build(builder(openCl).substeps(4), many)) {
            one.step(6);
            other.step(6);
            assertEquals(one.stateHash(), other.stateHash());
        }
    }

    /** A GPU gets work-groups for about as many tiles as had anything in them in the step before. */
    @Test
    void tilesThatSuddenlyAreManyAreAllDone() {
        try (Circles2D one = builder(ComputeDevice.host()).gravity(0, 0).build();
                Circles2D other = builder(openCl).gravity(0, 0).workGroup(64).build()) {
            for (Circles2D world : new Circles2D[] {one, other}) {
                // pairs that overlap, close together, then far apart
                SplittableRandom random = new SplittableRandom(1);
                long[] circles = new long[1500];
                for (int i = 0; i < circles.length; i += 2) {
                    double angle = random.nextDouble(2 * Math.PI);
                    double distance = 0.03 * Math.sqrt(random.nextDouble());
                    float x = 0.5f + (float) (distance * Math.cos(angle));
                    float y = 0.5f + (float) (distance * Math.sin(angle));
                    circles[i] = world.addCircle(x, y, 0.0005f, 1);
                    circles[i + 1] = world.addCircle(x + 0.0003f, y, 0.0005f, 1);
                }
                world.step();
                Snapshot now = world.snapshot();
                for (int i = 0; i < circles.length; i++) {
                    float vx = 200 * (now.x(i & ~1) - 0.5f);
                    world.setVelocity(circles[i], vx, 200 * (now.y(i & ~1) - 0.5f));
                }
            }
            for (int step = 1; step <= 5; step++) {
                one.step();
                other.step();
                assertEquals(one.stateHash(), other.stateHash(), "step " + step);
            }
        }
    }

    @Test
    void theThesisSolverHasOneHashWithTheGridToo() {
        for (Scene scene : Scene.ALL) {
            long expected = thesisHash(scene, ComputeDevice.host(), IndexStrategy.folded());
            assertEquals(expected, thesisHash(scene, ComputeDevice.host(), IndexStrategy.grid()), scene.name());
            assertEquals(expected, thesisHash(scene, openCl, IndexStrategy.grid()), scene.name());
        }
    }

    private static long thesisHash(Scene scene, ComputeDevice device, IndexStrategy strategy) {
        Circles2D.Builder builder = builder(device).solver(Solver.IMPULSE).indexStrategy(strategy);
        try (Circles2D world = scene.build(builder, 400)) {
            world.step(60);
            return world.stateHash();
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, Tuning.ALONE_CIRCLES})
    void moreContactsThanThereIsRoomForLoseNothing(int oneTile) {
        try (Circles2D host = builder(ComputeDevice.host()).oneTile(oneTile).build();
                Circles2D device = builder(openCl).oneTile(oneTile).build()) {
            for (Circles2D world : new Circles2D[] {host, device}) {
                // a ring that meets in the middle in the fourth substep, where every circle lists every other
                for (int i = 0; i < 400; i++) {
                    double angle = 2 * Math.PI * i / 400;
                    world.addCircle(new CircleDef()
                            .position(
                                    0.5f + 0.4f * (float) StrictMath.cos(angle),
                                    0.5f + 0.4f * (float) StrictMath.sin(angle))
                            .radius(0.003f)
                            .mass(1)
                            .velocity(-48 * (float) StrictMath.cos(angle), -48 * (float) StrictMath.sin(angle)));
                }
            }
            for (int step = 1; step <= 30; step++) {
                host.step();
                device.step();
                assertEquals(host.stateHash(), device.stateHash(), "step " + step);
            }
            SplittableRandom random = new SplittableRandom(5);
            for (int i = 0; i < 200; i++) {
                float radius = 0.004f + 0.001f * (float) random.nextDouble();
                host.addCircle(0.5f, 0.6f, radius, 1);
                device.addCircle(0.5f, 0.6f, radius, 1);
            }
            host.step(30);
            device.step(30);
            assertEquals(host.stateHash(), device.stateHash());
        }
    }

    /** More circles in a tile than a work-group has local memory for. */
    @Test
    void tilesThatDoNotFitHaveTheSameBits() {
        try (Circles2D host = builder(ComputeDevice.host()).oneTile(0).build();
                Circles2D device = builder(openCl).oneTile(0).build()) {
            SplittableRandom random = new SplittableRandom(11);
            // a tile is some 36 radii wide; these lie in one, or a border parts them in two
            for (int i = 0; i < 3 * Tuning.TILE_CIRCLES; i++) {
                float x = 0.3f + 0.04f * (float) random.nextDouble();
                float y = 0.3f + 0.04f * (float) random.nextDouble();
                float radius = 0.004f + 0.001f * (float) random.nextDouble();
                host.addCircle(x, y, radius, 1);
                device.addCircle(x, y, radius, 1);
            }
            for (int step = 1; step <= 4; step++) {
                host.step();
                device.step();
                assertEquals(host.stateHash(), device.stateHash(), "step " + step);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 310, Tuning.ALONE_CIRCLES})
    void whatIsRememberedSurvivesNewCirclesNewSpeedsAndOtherSubsteps(int oneTile) {
        try (Circles2D host = Scene.PILE.build(
                        builder(ComputeDevice.host()).oneTile(oneTile).substeps(0), 300);
                Circles2D device =
                        Scene.PILE.build(builder(openCl).oneTile(oneTile).substeps(0), 300)) {
            SplittableRandom random = new SplittableRandom(7);
            for (int round = 0; round < 12; round++) {
                float x = 0.1f + 0.8f * (float) random.nextDouble();
                float radius = round == 5 ? 0.1f : round == 8 ? 0.001f : 0.01f;
                float speed = (float) random.nextDouble(-30, 30);
                int which = random.nextInt(300);
                for (Circles2D world : new Circles2D[] {host, device}) {
                    world.step(7);
                    world.setVelocity(world.addCircle(x, 0.8f, radius, 5), speed, 0);
                    world.setVelocity(which, 0, 1);
                }
                assertEquals(host.stateHash(), device.stateHash(), "round " + round);
            }
            host.step(60);
            device.step(60);
            assertEquals(host.stateHash(), device.stateHash());
        }
    }

    @Test
    void lookingAtAWorldAndUploadingItAgainChangesNothing() {
        for (ComputeDevice device : ComputeDevice.list()) {
            try (Circles2D one = Scene.PILE.build(builder(device), 200);
                    Circles2D other = Scene.PILE.build(builder(device), 200)) {
                one.step(200);
                for (int step = 0; step < 200; step++) {
                    other.step();
                    Snapshot now = other.snapshot();
                    other.setVelocity(3, now.vx(3), now.vy(3));
                }
                assertEquals(one.stateHash(), other.stateHash(), device.name());
            }
        }
    }
}
