package io.github.circles2d.pipeline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.host.HostSmallStages;
import java.nio.FloatBuffer;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A step goes on with the contacts that one before has listed, as long as none can be missing. */
class SkinTest {
    private static final int CIRCLES = 400;
    private static final int SETTLED = 400;

    private final FloatBuffer transforms = SmallSteps.direct(4 * (CIRCLES + 1));
    private final FloatBuffer masses = SmallSteps.direct(CIRCLES + 1);
    private final FloatBuffer velocities = SmallSteps.direct(2 * (CIRCLES + 1));
    private SmallStages stages;
    private SmallPipeline pipeline;
    private int circles = CIRCLES;
    private int detections;
    /** How often how circles move was looked at. */
    private int looks;

    private void start(float gravity) {
        WorldConfig config = SmallSteps.box(1, Tuning.ALONE_CIRCLES, gravity);
        HostSmallStages host = new HostSmallStages(config);
        stages = SmallSteps.stages((proxy, method, arguments) -> {
            detections += method.getName().equals("detect") ? 1 : 0;
            looks += method.getName().equals("motion") ? 1 : 0;
            return method.invoke(host, arguments);
        });
        pipeline = new SmallPipeline(config, stages);
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < CIRCLES; i++) {
            circle(i, (0.5f + i % 25) / 25, (0.5f + i / 25) / 25, 0.01f + 0.005f * (float) random.nextDouble());
        }
    }

    /** A pile that stands. */
    private void settle() {
        start(-1);
        upload();
        for (int step = 0; step < SETTLED; step++) {
            step();
        }
        detections = 0;
        looks = 0;
    }

    private void circle(int i, float x, float y, float radius) {
        transforms.put(4 * i, x).put(4 * i + 1, y).put(4 * i + 2, radius);
        masses.put(i, radius * radius);
        velocities.put(2 * i, 0).put(2 * i + 1, 0);
    }

    private void upload() {
        pipeline.upload(Population.of(transforms, masses, circles), velocities, SmallSteps.all(circles));
    }

    private void step() {
        pipeline.step();
        pipeline.await();
        stages.download(transforms, velocities);
    }

    private void everyOverlapIsListed() {
        int overlapping = 0;
        for (int i = 0; i < circles; i++) {
            for (int j = i + 1; j < circles; j++) {
                float dx = transforms.get(4 * i) - transforms.get(4 * j);
                float dy = transforms.get(4 * i + 1) - transforms.get(4 * j + 1);
                float radii = transforms.get(4 * i + 2) + transforms.get(4 * j + 2);
                overlapping += radii - (float) Math.sqrt(dx * dx + dy * dy) > 0 ? 1 : 0;
            }
        }
        assertEquals(overlapping, stages.sums().touching());
    }

    @Test
    void whereAPileStandsContactsAreSeldomListed() {
        settle();
        for (int step = 0; step < 100; step++) {
            step();
            everyOverlapIsListed();
        }
        assertTrue(detections <= 10, detections + " detections in 100 steps");
    }

    @Test
    void whatDriftsIsListedBeforeItMeets() {
        start(0);
        SplittableRandom random = new SplittableRandom(2);
        for (int k = 0; k < 2 * CIRCLES; k++) {
            velocities.put(k, 0.03f * (float) random.nextDouble(-1, 1));
        }
        upload();
        for (int step = 0; step < 300; step++) {
            step();
            everyOverlapIsListed();
        }
        assertTrue(detections > 30 && detections < 200, detections + " detections in 300 steps");
    }

    @Test
    void whereACircleIsFastEveryStepListsItsOwn() {
        settle();
        velocities.put(0, 3).put(1, 1);
        pipeline.velocities(velocities, SmallSteps.all(1));
        for (int step = 1; step <= 3; step++) {
            detections = 0;
            step();
            assertTrue(detections > 0, "none in step " + step);
        }
    }

    @Test
    void aVelocityThatStaysAsItIsListsNothingAnew() {
        settle();
        for (int step = 0; step < 20; step++) {
            upload();
            step();
            everyOverlapIsListed();
        }
        assertTrue(detections <= 4, detections + " detections in 20 steps");
    }

    @Test
    void aCircleThatIsAddedIsListedAtOnce() {
        settle();
        circle(CIRCLES, 0.5f, 0.05f, 0.015f);
        circles++;
        upload();
        step();
        assertEquals(1, detections);
        everyOverlapIsListed();
    }

    @Test
    void whereAPileStandsStepsAreSeldomLookedAtWhoeverAsksForThem() {
        SkinTest asking = new SkinTest();
        asking.settle();
        settle();
        for (int step = 0; step < 100; step++) {
            asking.step();
            pipeline.step();
        }
        pipeline.await();
        stages.download(transforms, velocities);
        assertArrayEquals(
                SmallSteps.bits(asking.transforms, asking.velocities, CIRCLES),
                SmallSteps.bits(transforms, velocities, CIRCLES));
        assertTrue(looks > 10 && looks < 60, looks + " looks in 100 steps");
        assertEquals(looks, asking.looks);
        assertEquals(detections, asking.detections);
    }

    @Test
    void aVelocitySetBetweenLooksCountsAtOnce() {
        settle();
        int before;
        do {
            before = looks;
            step();
        } while (looks > before);
        velocities.put(0, 3).put(1, 1);
        pipeline.velocities(velocities, SmallSteps.all(1));
        assertEquals(before + 1, looks);
        detections = 0;
        step();
        assertTrue(detections > 0, "none in the step after it");
        everyOverlapIsListed();
    }

    @ParameterizedTest
    @CsvSource({"0, 10", "1, 80"})
    void largerWorldsAreLookedAtAfterEachStep(int more, int expected) {
        int many = Tuning.ALONE_CIRCLES + more;
        FloatBuffer still = SmallSteps.direct(4 * many);
        FloatBuffer ones = SmallSteps.direct(many);
        for (int i = 0; i < many; i++) {
            still.put(4 * i, (1 + i % 40) / 42f)
                    .put(4 * i + 1, (1 + i / 40) / 42f)
                    .put(4 * i + 2, 0.005f);
            ones.put(i, 1);
        }
        start(0);
        pipeline.upload(Population.of(still, ones, many), SmallSteps.direct(2 * many), SmallSteps.all(many));
        for (int step = 0; step < 80; step++) {
            pipeline.step();
        }
        pipeline.await();
        assertEquals(expected, looks, 1);
    }
}
