package io.github.circles2d.host;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Workers;
import java.util.Arrays;

/** Twin of {@code kernels/grid.cl}: sorts the circles by bucket, and by number within each. */
final class Grid {
    private final SmallState state;
    private final Workers workers;
    private final Workers.Work bin = this::bin;
    private final Workers.Work order = this::order;
    private float[] sorted = {};
    private int[] sortedId = {};
    /** By number: the bucket, and the place at the detection before. */
    private int[] bucketOf = {};

    private int[] placeOf = {};

    Grid(SmallState state, Workers workers) {
        this.state = state;
        this.workers = workers;
    }

    void run() {
        ready(state.levels.cells);
        workers.run(state.circles, bin);
        int[] start = state.bucketStart;
        for (int d = 0; d < state.circles; d++) {
            start[bucketOf[d]]++;
        }
        for (int bucket = 1; bucket <= state.levels.cells; bucket++) {
            start[bucket] += start[bucket - 1];
        }
        // from the last number to the first, each takes the last free place: lower numbers come first
        for (int d = state.circles - 1; d >= 0; d--) {
            sortedId[--start[bucketOf[d]]] = d;
        }
        workers.run(state.circles, order);
        float[] swap = state.body;
        state.body = sorted;
        sorted = swap;
        int[] swapId = state.id;
        state.id = sortedId;
        sortedId = swapId;
    }

    private void bin(int part, int from, int end) {
        Levels levels = state.levels;
        for (int i = from; i < end; i++) {
            int at = Levels.at(levels.levelOf(state.body[SmallState.BODY * i + SmallState.RADIUS]));
            int shift = levels.table[at + Levels.SHIFT];
            placeOf[state.id[i]] = i;
            bucketOf[state.id[i]] = levels.bucket(at, state.column(i) >> shift, state.row(i) >> shift);
        }
    }

    private void order(int part, int from, int end) {
        for (int to = from; to < end; to++) {
            int before = placeOf[sortedId[to]];
            System.arraycopy(state.body, SmallState.BODY * before, sorted, SmallState.BODY * to, SmallState.BODY);
            state.from[to] = before;
        }
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
