package io.github.circles2d.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

class ChangesTest {
    @Test
    void runsHoldEachChangeOnceAndLittleElse() {
        SplittableRandom random = new SplittableRandom(1);
        Changes changes = new Changes();
        int several = 0;
        for (int world = 0; world < 500; world++) {
            int circles = 1 + random.nextInt(world % 2 == 0 ? 3000 : 300_000);
            TreeSet<Integer> left = new TreeSet<>();
            for (int k = random.nextInt(12); k > 0; k--) {
                left.add(random.nextInt(circles));
            }
            left.forEach(changes::add);
            int apart = world % 3 * 20_000;
            int before = -apart - 1;
            int runs = 0;
            for (changes.rewind(circles, apart); changes.next(); runs++) {
                int gap = changes.from() - before;
                assertTrue(gap > apart - Tuning.CHANGED_TOGETHER, "runs so near each other are one");
                assertTrue(changes.from() < changes.end() && changes.end() <= circles);
                assertTrue(left.first() - changes.from() < Tuning.CHANGED_TOGETHER);
                int last = changes.from();
                while (!left.isEmpty() && left.first() < changes.end()) {
                    int next = left.pollFirst();
                    assertTrue(next - last < apart + 2 * Tuning.CHANGED_TOGETHER, "too much besides");
                    last = next;
                }
                assertTrue(changes.end() - last <= Tuning.CHANGED_TOGETHER);
                before = changes.end();
            }
            assertEquals(0, left.size());
            several += runs > 1 ? 1 : 0;
            // a second time they are the same
            changes.rewind(circles, apart);
            assertEquals(runs > 0, changes.next());
            changes.clear();
            changes.rewind(circles, apart);
            assertFalse(changes.next());
        }
        assertTrue(several > 50, "worlds of several runs: " + several);
    }

    @Test
    void thoseThatMoveAreLookedThroughAlone() {
        Changes changes = new Changes();
        int circles = 5 * Tuning.CHANGED_TOGETHER;
        for (int i = 0; i < circles; i++) {
            changes.add(i, i == 2 * Tuning.CHANGED_TOGETHER);
        }
        changes.rewindMoving(circles);
        assertTrue(changes.next());
        assertEquals(2 * Tuning.CHANGED_TOGETHER, changes.from());
        assertEquals(3 * Tuning.CHANGED_TOGETHER, changes.end());
        assertFalse(changes.next());
        changes.rewind(circles, 0);
        assertTrue(changes.next());
        assertEquals(0, changes.from());
        assertEquals(circles, changes.end());
        // among these may be others that move
        changes.add(2 * Tuning.CHANGED_TOGETHER, false);
        changes.rewindMoving(circles);
        assertTrue(changes.next());
        changes.clear();
        changes.rewindMoving(circles);
        assertFalse(changes.next());
    }

    @Test
    void circlesAddedTogetherAreTheSameAsOneByOne() {
        int circles = 7 * Tuning.CHANGED_TOGETHER;
        int[] ends = {0, 1, Tuning.CHANGED_TOGETHER - 1, Tuning.CHANGED_TOGETHER, 3 * Tuning.CHANGED_TOGETHER + 5};
        for (int from : ends) {
            for (int end : ends) {
                Changes together = new Changes();
                Changes apart = new Changes();
                for (boolean moves : new boolean[] {false, true}) {
                    together.add(from, end, moves);
                    for (int i = from; i < end; i++) {
                        apart.add(i, moves);
                    }
                    assertSameRuns(circles, apart, together);
                }
            }
        }
    }

    private static void assertSameRuns(int circles, Changes wanted, Changes changes) {
        for (boolean moving : new boolean[] {false, true}) {
            for (Changes each : new Changes[] {wanted, changes}) {
                if (moving) {
                    each.rewindMoving(circles);
                } else {
                    each.rewind(circles, 0);
                }
            }
            while (wanted.next()) {
                assertTrue(changes.next());
                assertEquals(wanted.from(), changes.from());
                assertEquals(wanted.end(), changes.end());
            }
            assertFalse(changes.next());
        }
    }
}
