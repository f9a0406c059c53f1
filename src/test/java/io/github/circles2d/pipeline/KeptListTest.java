package io.github.circles2d.pipeline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import io.github.circles2d.TestDevices;
import io.github.circles2d.host.HostDevice;
import java.nio.FloatBuffer;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Contacts outgrow their room in a step whose list the steps after it go on with. */
class KeptListTest {
    private static final int STEPS = 8;
    /** How far circles come is known after a step: the list of the second is the first that is kept. */
    private static final int LISTED = 2;

    /** A world, and how often it was told to detect and to make room. */
    private static final class World implements AutoCloseable {
        final FloatBuffer transforms;
        final FloatBuffer masses;
        final FloatBuffer velocities;
        int detections;
        int rooms;
        private final SmallStages stages;
        private final SmallPipeline pipeline;

        World(Device device, WorldConfig config, int columns, int rows) {
            SmallStages real = device.openSmall(config);
            stages = SmallSteps.stages((proxy, method, arguments) -> {
                detections += method.getName().equals("detect") ? 1 : 0;
                rooms += method.getName().equals("makeRoom") ? 1 : 0;
                return method.invoke(real, arguments);
            });
            pipeline = new SmallPipeline(config, stages);
            transforms = SmallSteps.direct(4 * columns * rows);
            masses = SmallSteps.direct(columns * rows);
            velocities = SmallSteps.direct(2 * columns * rows);
            lay(columns, rows);
            pipeline.upload(
                    Population.of(transforms, masses, columns * rows), velocities, SmallSteps.all(columns * rows));
        }

        /** A square lattice, a hundredth of a radius open, that drifts apart and together: with the skin, diagonals are within reach. */
        private void lay(int columns, int rows) {
            SplittableRandom random = new SplittableRandom(3);
            float spacing = 1f / (Math.max(columns, rows) + 1);
            float radius = spacing / 2.01f;
            for (int i = 0; i < columns * rows; i++) {
                transforms.put(4 * i, spacing * (1 + i % columns)).put(4 * i + 1, spacing * (1 + i / columns));
                transforms.put(4 * i + 2, radius);
                masses.put(i, 1);
                velocities.put(2 * i, 0.6f * radius * (float) random.nextDouble(-1, 1));
                velocities.put(2 * i + 1, 0.6f * radius * (float) random.nextDouble(-1, 1));
            }
        }

        int[] step() {
            pipeline.step();
            pipeline.await();
            stages.download(transforms, velocities);
            return SmallSteps.bits(transforms, velocities, masses.capacity());
        }

        @Override
        public void close() {
            stages.close();
        }
    }

    @ParameterizedTest
    @CsvSource({"40, 40, 0", "35, 36, " + Tuning.ALONE_CIRCLES})
    void aListThatOutgrewItsRoomIsKeptAsAnyOther(int columns, int rows, int oneTile) {
        WorldConfig config = SmallSteps.box(1, oneTile, 0);
        try (World host = new World(new HostDevice(), config, columns, rows);
                World device = new World(TestDevices.openClInside(), config, columns, rows)) {
            for (int step = 1; step <= STEPS; step++) {
                assertArrayEquals(host.step(), device.step(), "step " + step);
                if (step == LISTED) {
                    assertEquals(1, device.rooms);
                }
            }
            assertEquals(1, device.rooms);
            assertEquals(LISTED, host.detections);
            assertEquals(LISTED + 1, device.detections, "of the last one the list was kept");
        }
    }
}
