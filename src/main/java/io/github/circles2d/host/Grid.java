package io.github.circles2d.host;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.WorldConfig;
import java.util.Arrays;

/** Twin of {@code kernels/grid.cl}: sorts the circles by bucket, and by number within each. */
final class Grid {
    private final WorldConfig config;
    private final SmallState state;
    private float[] sorted = {};
    private int[] sortedId = {};
    private int[] place = {};

    Grid(WorldConfig config, SmallState state) {
        this.config = config;
        this.state = state;
    }

    void run() {
        Levels levels = state.levels;
        turn(levels.cells);
        int[] start = state.bucketStart;
        int lastColumn = levels.lastColumn(config);
        int lastRow = levels.lastRow(config);
        for (int i = 0; i < state.circles; i++) {
            int d = state.id[i];
            int b = SmallState.BODY * i;
            int c = SmallState.CELL * d;
            int at = Levels.INTS * state.level[d];
            int shift = levels.table[at + Levels.SHIFT];
            int x = levels.finest(state.body[b], config.minX(), lastColumn);
            int y = levels.finest(state.body[b + 1], config.minY(), lastRow);
            state.cell[c] = x;
            state.cell[c + 1] = y;
            state.cell[c + 2] = state.level[d];
            place[d] = i;
            start[levels.bucket(at, x >> shift, y >> shift)]++;
        }
        for (int bucket = 1; bucket <= levels.cells; bucket++) {
            start[bucket] += start[bucket - 1];
        }
        // from the last number to the first, each takes the last free place: lower numbers come first
        for (int d = state.circles - 1; d >= 0; d--) {
            int c = SmallState.CELL * d;
            int at = Levels.INTS * state.level[d];
            int shift = levels.table[at + Levels.SHIFT];
            int to = --start[levels.bucket(at, state.cell[c] >> shift, state.cell[c + 1] >> shift)];
            System.arraycopy(state.body, SmallState.BODY * place[d], sorted, SmallState.BODY * to, SmallState.BODY);
            sortedId[to] = d;
        }
        float[] swap = state.body;
        state.body = sorted;
        sorted = swap;
        int[] swapId = state.id;
        state.id = sortedId;
        sortedId = swapId;
    }

    /** What was this detection is now the one before. */
    private void turn(int buckets) {
        int[] swap = state.cell;
        state.cell = state.cellBefore;
        state.cellBefore = swap;
        if (state.bucketStart.length < buckets + 1) {
            state.bucketStart = new int[buckets + 1];
        } else {
            Arrays.fill(state.bucketStart, 0, buckets + 1, 0);
        }
        if (sortedId.length != state.id.length) {
            sorted = new float[state.body.length];
            sortedId = new int[state.id.length];
            place = new int[state.id.length];
        }
    }
}
