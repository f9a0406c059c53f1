package io.github.circles2d.opencl;

import static org.junit.jupiter.api.Assertions.assertEquals;

import io.github.circles2d.TestDevices;
import io.github.circles2d.pipeline.SmallSteps;
import io.github.circles2d.pipeline.Tuning;
import java.nio.FloatBuffer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What one thread carries, the first few times, and then several. */
class StagedCirclesTest {
    private static final int FIRST = 7;
    private static final int CIRCLES = 3 * Tuning.COPY_CIRCLES + 11;
    private static final int ALL = FIRST + CIRCLES + 5;

    @BeforeEach
    void openCl() {
        TestDevices.openCl();
    }

    private static FloatBuffer counted(int floats, int from) {
        FloatBuffer buffer = SmallSteps.direct(floats);
        for (int k = 0; k < floats; k++) {
            buffer.put(k, from + k);
        }
        return buffer;
    }

    @Test
    void everyCircleComesThereAndBackEveryTime() {
        FloatBuffer transforms = counted(4 * ALL, 0);
        FloatBuffer masses = counted(ALL, 1 << 20);
        FloatBuffer velocities = counted(2 * ALL, 1 << 21);
        try (Session session = new Session(OpenClDevices.list(JoclApi.load()).get(0))) {
            Staging staging = new Staging(session);
            staging.ensure(16 * CIRCLES);
            StagedCircles staged = new StagedCircles(staging);
            for (int turn = 0; turn < Tuning.COPIES_ALONE; turn++) {
                FloatBuffer back = SmallSteps.direct(4 * ALL);
                staged.toStaging(transforms, masses, StagedCircles.TRANSFORM, FIRST, CIRCLES);
                for (int i = 0; i < CIRCLES; i++) {
                    assertEquals((1 << 20) + FIRST + i, staging.floats().get(4 * i + 3));
                }
                staged.toHost(0, back, StagedCircles.TRANSFORM, FIRST, CIRCLES);
                for (int k = 0; k < 4 * ALL; k++) {
                    boolean carried = k >= 4 * FIRST && k < 4 * (FIRST + CIRCLES) && k % 4 < 3;
                    assertEquals(carried ? k : 0, back.get(k));
                }
                back = SmallSteps.direct(2 * ALL);
                staged.toStaging(velocities, null, StagedCircles.VELOCITY, FIRST, CIRCLES);
                staged.toHost(0, back, StagedCircles.VELOCITY, FIRST, CIRCLES);
                for (int k = 0; k < 2 * ALL; k++) {
                    boolean carried = k >= 2 * FIRST && k < 2 * (FIRST + CIRCLES);
                    assertEquals(carried ? (1 << 21) + k : 0, back.get(k));
                }
            }
        }
    }
}
