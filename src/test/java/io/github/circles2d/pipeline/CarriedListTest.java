package io.github.circles2d.pipeline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.TestDevices;
import io.github.circles2d.host.HostDevice;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Worlds of many list contacts for more substeps than a step has left; the next step begins with those. */
class CarriedListTest {
    private static final int SIDE = 450;
    private static final int CIRCLES = SIDE * SIDE;
    private static final float SPACING = 1f / (SIDE + 1);
    private static final float RADIUS = SPACING / 4;
    /** A list is for at most 16. */
    private static final int STEPS_A_SECOND = 240;

    private static final int SUBSTEPS = 4;
    private static final int STEPS = 12;

    private final List<World> worlds = new ArrayList<>();

    /** A square lattice of many, each of which goes its own way; and what its stages were told. */
    private static final class World {
        final FloatBuffer transforms = SmallSteps.direct(4 * CIRCLES);
        final FloatBuffer velocities = SmallSteps.direct(2 * CIRCLES);
        final SmallStages stages;
        final SmallPipeline pipeline;
        /** Substeps up to each detection, and all of them. */
        final List<Integer> detections = new ArrayList<>();

        int substeps;
        /** The detection that finds no room the first time, or -1. */
        int stalls = -1;

        private boolean stalled;
        /** Detections up to the step. */
        private int before;

        /**
         * A world of a device.
         *
         * @param speed most along each axis, radii a second
         */
        World(Device device, float speed) {
            WorldConfig config = SmallSteps.box(1, 0, 0, STEPS_A_SECOND, SUBSTEPS);
            SmallStages real = device.openSmall(config);
            stages = SmallSteps.stages((proxy, method, arguments) -> told(method.getName(), arguments)
                    ? method.invoke(real, arguments)
                    : method.getName().equals("await") ? stall() : null);
            pipeline = new SmallPipeline(config, stages);
            FloatBuffer masses = SmallSteps.direct(CIRCLES);
            SplittableRandom random = new SplittableRandom(5);
            for (int i = 0; i < CIRCLES; i++) {
                transforms.put(4 * i, SPACING * (1 + i % SIDE)).put(4 * i + 1, SPACING * (1 + i / SIDE));
                transforms.put(4 * i + 2, RADIUS);
                masses.put(i, 1);
                velocities.put(2 * i, speed * RADIUS * (float) random.nextDouble(-1, 1));
                velocities.put(2 * i + 1, speed * RADIUS * (float) random.nextDouble(-1, 1));
            }
            pipeline.upload(Population.of(transforms, masses, CIRCLES), velocities, SmallSteps.all(CIRCLES));
        }

        /** Keeps books; whether the stages are to be told, too. As on a device, a detection without room does nothing, nor what comes after it. */
        private boolean told(String name, Object[] arguments) {
            if (name.equals("detect") && detections.size() == stalls) {
                stalls = -1;
                stalled = true;
            } else if (name.equals("detect") && !stalled) {
                detections.add(substeps);
            } else if (name.equals("solve") && !stalled) {
                substeps += (int) arguments[0];
            }
            return !stalled && !name.equals("makeRoom");
        }

        private Status stall() {
            stalled = false;
            return new Status().set(1, true, detections.size() - before);
        }

        /** A step; returns all bits of all circles. */
        int[] step() {
            before = detections.size();
            pipeline.step();
            pipeline.await();
            stages.download(transforms, velocities);
            return SmallSteps.bits(transforms, velocities, CIRCLES);
        }

        /** Overlaps, looked for in cells a lattice's spacing wide. */
        int overlapping() {
            int[] first = new int[(SIDE + 2) * (SIDE + 2)];
            int[] next = new int[CIRCLES + 1];
            int overlaps = 0;
            for (int i = 0; i < CIRCLES; i++) {
                int cell = cell(transforms.get(4 * i)) + (SIDE + 2) * cell(transforms.get(4 * i + 1));
                for (int near : new int[] {0, 1, -1, SIDE + 1, SIDE + 2, SIDE + 3, -SIDE - 1, -SIDE - 2, -SIDE - 3}) {
                    int at = cell + near;
                    for (int j = at < 0 || at >= first.length ? 0 : first[at]; j > 0; j = next[j]) {
                        overlaps += overlap(i, j - 1) ? 1 : 0;
                    }
                }
                next[i + 1] = first[cell];
                first[cell] = i + 1;
            }
            return overlaps;
        }

        private static int cell(float coordinate) {
            return (int) (coordinate / SPACING);
        }

        private boolean overlap(int i, int j) {
            float dx = transforms.get(4 * i) - transforms.get(4 * j);
            float dy = transforms.get(4 * i + 1) - transforms.get(4 * j + 1);
            return 2 * RADIUS - (float) Math.sqrt(dx * dx + dy * dy) > 0;
        }
    }

    private World world(Device device, float speed) {
        World world = new World(device, speed);
        worlds.add(world);
        return world;
    }

    @AfterEach
    void close() {
        worlds.forEach(world -> world.stages.close());
    }

    @Test
    void aListIsGoodForMoreThanAStep() {
        World host = world(new HostDevice(), 120);
        int missing = 0;
        for (int step = 1; step <= STEPS; step++) {
            host.step();
            int touching = (int) host.stages.sums().touching();
            missing = Math.max(missing, host.overlapping() - touching);
            assertTrue(missing == 0 || step > 4, missing + " before any could be sent elsewhere");
        }
        assertTrue(host.overlapping() > 100, host.overlapping() + " overlaps");
        // where one circle hits a second, and that then a third, the last two were on nobody's list
        assertTrue(missing < CIRCLES / 1000, missing + " overlaps that were not listed");
        assertTrue(host.detections.size() <= STEPS * 2 / 3, host.detections + " detections");
        assertTrue(host.detections.stream().anyMatch(s -> s % SUBSTEPS != 0), host.detections + ": all at steps");
        assertEquals(STEPS * SUBSTEPS, host.substeps);
    }

    @Test
    void devicesHaveTheSameBits() {
        World host = world(new HostDevice(), 120);
        World device = world(TestDevices.openClInside(), 120);
        for (int step = 1; step <= 6; step++) {
            assertArrayEquals(host.step(), device.step(), "step " + step);
        }
        assertEquals(host.detections, device.detections);
        assertTrue(host.detections.stream().anyMatch(s -> s % SUBSTEPS != 0), host.detections + ": all at steps");
    }

    @ParameterizedTest
    @ValueSource(floats = {120, 500})
    void aStepThatStallsWithinGoesOnThere(float speed) {
        World host = world(new HostDevice(), speed);
        World stalling = world(new HostDevice(), speed);
        for (int stalls = 1; stalls <= 3; stalls++) {
            stalling.stalls = stalling.detections.size() + stalls % 2;
            for (int step = 0; step < 6; step++) {
                assertArrayEquals(host.step(), stalling.step());
            }
            assertEquals(-1, stalling.stalls);
        }
        assertEquals(host.detections, stalling.detections);
        assertEquals(host.substeps, stalling.substeps);
    }

    @Test
    void aVelocityThatIsSetListsAnew() {
        World host = world(new HostDevice(), 120);
        host.step();
        host.step();
        assertEquals(1, host.detections.size());
        host.velocities.put(0, 0).put(1, 0);
        Changes first = new Changes();
        first.add(0);
        host.pipeline.velocities(host.velocities, first);
        host.step();
        assertEquals(List.of(0, 2 * SUBSTEPS), host.detections.subList(0, 2));
    }
}
