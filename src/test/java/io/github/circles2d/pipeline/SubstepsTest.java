package io.github.circles2d.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.FloatBuffer;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** How often contacts are listed follows from how circles move. */
class SubstepsTest {
    private static final WorldConfig CONFIG = SmallSteps.box(1, 0, 0);
    private static final float RADIUS = 1e-4f;

    /** Circles of one size that all go as fast in one direction, the first of them apart. */
    private static int perDetection(int circles, float vx, float firstX) {
        FloatBuffer transforms = FloatBuffer.allocate(4 * circles);
        FloatBuffer velocities = FloatBuffer.allocate(2 * circles);
        for (int i = 0; i < circles; i++) {
            transforms.put(4 * i, 0.5f).put(4 * i + 1, 0.5f).put(4 * i + 2, RADIUS);
            velocities.put(2 * i, i == 0 ? firstX : vx);
        }
        Population population = Population.of(transforms, null, circles);
        Motion motion = new Motion();
        population.motion(velocities, 0, circles, motion);
        Levels levels = Levels.all(CONFIG, population)[0];
        return Substeps.of(CONFIG, 64).perDetection(CONFIG, population, motion, levels);
    }

    @Test
    void manyAreListedLessOftenThanEachAtItsFastestAgainstTheOther() {
        int few = Tuning.CLOSING_CIRCLES;
        float speed = 20 * RADIUS * 60;
        assertTrue(perDetection(few, speed, speed) < 5);
        assertEquals(perDetection(few, speed, speed), perDetection(few, speed, -speed));
        // against those that rest they are as fast as that
        int together = perDetection(few + 1, speed, speed);
        assertTrue(together >= 2 * perDetection(few, speed, speed) - 1, together + " together");
        assertEquals(perDetection(few, speed, -speed), perDetection(few + 1, speed, -speed), 1);
    }

    @Test
    void noTwoCloseInFasterThanMotionSays() {
        SplittableRandom random = new SplittableRandom(1);
        for (int turn = 0; turn < 1000; turn++) {
            float[] v = new float[10];
            Motion motion = new Motion();
            for (int k = 0; k < v.length; k += 2) {
                v[k] = (float) random.nextDouble(-1, 2);
                v[k + 1] = (float) random.nextDouble(-3, 1);
                motion.add(v[k], v[k + 1], 1, 0, 0);
            }
            for (int a = 0; a < v.length; a += 2) {
                for (int b = 0; b < v.length; b += 2) {
                    double closing = Math.hypot(v[a] - v[b], v[a + 1] - v[b + 1]);
                    assertTrue(closing <= motion.closing() * 1.000001, closing + " of " + motion.closing());
                }
                assertTrue(Math.hypot(v[a], v[a + 1]) <= motion.speed() * 1.000001);
            }
        }
    }

    @Test
    void newVelocitiesAddToHowTheyMovedBefore() {
        Motion before = new Motion();
        before.add(1, 2, 3, 0.3f, 0.4f);
        Motion motion = new Motion();
        motion.add(before);
        motion.add(-3, 0, 3, 0, 0);
        assertEquals(0.5f, motion.moved(), 1e-6f);
        assertEquals(1, motion.fastest());
        assertEquals(Math.hypot(1 + 3, 2), motion.closing(), 1e-6f);
        assertEquals(Math.hypot(1, 2), before.speed(), 1e-6f);
        motion.anyFar();
        assertEquals(Float.POSITIVE_INFINITY, motion.moved());
        motion.clear();
        assertEquals(0, motion.speed());
        assertEquals(0, motion.moved());
    }
}
