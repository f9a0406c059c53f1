package io.github.circles2d.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.FloatBuffer;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Circles of neighbouring cells, of any level, always share a tile of some tiling. */
class TilesTest {
    private static final int PAIRS = 20_000;

    @ParameterizedTest
    @CsvSource({
        "1, 1, 1",
        "1000, 1, 1",
        "1000, 1, 8",
        "1000, 1, 30",
        "300, 1, 1000",
        "40, 1, 1000",
        "100000, 1, 2",
        "2000, 50, 4",
        "2000, 0.02, 4"
    })
    void neighboursShareATile(int circles, float boxes, float ratio) {
        for (float reach : new float[] {Tuning.REACH, Tuning.REACH_FAR}) {
            neighboursShareATile(levels(circles, boxes, ratio, reach, 0));
        }
    }

    @Test
    void aSmallWorldIsOneTile() {
        for (int circles : new int[] {1, 1000}) {
            Tiles one = Tiles.of(levels(circles, 1, 8, Tuning.REACH, 1000));
            assertEquals(1, one.tilings);
            assertEquals(1, one.tiles);
            neighboursShareATile(levels(circles, 1, 8, Tuning.REACH, 1000));
        }
        assertEquals(1, Tiles.of(levels(0, 1, 1, Tuning.REACH, 0)).tilings);
        assertTrue(Tiles.of(levels(1001, 1, 8, Tuning.REACH, 1000)).tiles > 1);
    }

    private static Levels levels(int circles, float boxes, float ratio, float reach, int oneTile) {
        return Levels.of(SmallSteps.box(boxes, oneTile), population(circles, ratio), reach);
    }

    private static void neighboursShareATile(Levels levels) {
        Tiles tiles = Tiles.of(levels);
        SplittableRandom random = new SplittableRandom(levels.circles);
        for (int pair = 0; pair < PAIRS; pair++) {
            int at = Levels.at(random.nextInt(levels.count));
            int shift = levels.table[at + Levels.SHIFT];
            int lastX = levels.table[Levels.LAST_X];
            int lastY = levels.table[Levels.LAST_Y];
            int ax = random.nextInt(lastX + 1);
            int ay = random.nextInt(lastY + 1);
            int bx = neighbour(ax, shift, lastX, random);
            int by = neighbour(ay, shift, lastY, random);
            int shared = 0;
            for (int tiling = 0; tiling < tiles.tilings; tiling++) {
                int tile = tiles.tile(tiling, ax, ay);
                assertTrue(
                        tile >= tiles.first(tiling) && tile < tiles.first(tiling + 1),
                        "tile " + tile + " of tiling " + tiling);
                shared += tile == tiles.tile(tiling, bx, by) ? 1 : 0;
            }
            assertTrue(shared > 0, "(" + ax + ", " + ay + ") and (" + bx + ", " + by + ") at shift " + shift);
        }
    }

    /** A finest cell, along one axis, of the same cell of a level or of one beside it. */
    private static int neighbour(int a, int shift, int last, SplittableRandom random) {
        int cell = (a >> shift) + random.nextInt(-1, 2);
        int fine = (cell << shift) + random.nextInt(1 << shift);
        return Math.max(0, Math.min(last, fine));
    }

    private static Population population(int circles, float ratio) {
        FloatBuffer transforms = FloatBuffer.allocate(4 * circles);
        float least = 0.4f / (float) Math.sqrt(circles) / (float) Math.sqrt(ratio);
        for (int i = 0; i < circles; i++) {
            transforms.put(4 * i + 2, i == 0 ? least : i % 100 == 1 ? Math.min(0.5f, ratio * least) : 1.1f * least);
        }
        return Population.of(transforms, null, circles);
    }
}
