package io.github.circles2d.host;

import io.github.circles2d.pipeline.Levels;
import java.util.Arrays;

/** Twin of {@code kernels/grid.cl}: sorts the circles by bucket, and by number within each. */
final class Grid {
    private final SmallState state;
    private float[] sorted = {};
    private int[] sortedId = {};
    /** By number: the bucket, and the place at the detection before. */
    private int[] bucketOf = {};

    private int[] placeOf = {};

    Grid(SmallState state) {
        this.state = state;
    }

    void run() {
        Levels levels = state.levels;
        ready(levels.cells);
        int[] start = state.bucketStart;
        for (int i = 0; i < state.circles; i++) {
            int b = SmallState.BODY * i;
            int at = Levels.at(levels.levelOf(state.body[b + SmallState.RADIUS]));
            int shift = levels.table[at + Levels.SHIFT];
            int x = state.column(i);
            int y = state.row(i);
            int bucket = levels.bucket(at, x >> shift, y >> shift);
            placeOf[state.id[i]] = i;
            bucketOf[state.id[i]] = bucket;
            start[bucket]++;
        }
        for (int bucket = 1; bucket <= levels.cells; bucket++) {
            start[bucket] += start[bucket - 1];
        }
        // from the last number to the first, each takes the last free place: lower numbers come first
        for (int d = state.circles - 1; d >= 0; d--) {
            int to = --start[bucketOf[d]];
            System.arraycopy(state.body, SmallState.BODY * placeOf[d], sorted, SmallState.BODY * to, SmallState.BODY);
            sortedId[to] = d;
            state.from[to] = placeOf[d];
        }
        float[] swap = state.body;
        state.body = sorted;
        sorted = swap;
        int[] swapId = state.id;
        state.id = sortedId;
        sortedId = swapId;
    }

    private void ready(int buckets) {
        if (state.bucketStart.length < buckets + 1) {
            state.bucketStart = new int[buckets + 1];
        } else {
            Arrays.fill(state.bucketStart, 0, buckets + 1, 0);
        }
        if (sortedId.length != state.id.length) {
            sorted = new float[state.body.length];
            sortedId = new int[state.id.length];
            placeOf = new int[state.id.length];
            bucketOf = new int[state.id.length];
        }
    }
}
