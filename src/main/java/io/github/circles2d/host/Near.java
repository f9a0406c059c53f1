package io.github.circles2d.host;

import io.github.circles2d.pipeline.CellGrid;
import java.util.Arrays;

/** Twin of {@code kernels/near.cl}: finds the circles that overlap by a grid. */
final class Near {
    private final State state;
    private final Detect detect;
    private int[] start = {};
    private int[] near = {};

    Near(State state, Detect detect) {
        this.state = state;
        this.detect = detect;
    }

    void run(CellGrid cells) {
        if (start.length < cells.cells() + 1) {
            start = new int[cells.cells() + 1];
        } else {
            Arrays.fill(start, 0);
        }
        near = near.length < state.circles ? new int[state.circle.length / 4] : near;
        for (int i = 0; i < state.circles; i++) {
            start[cell(cells, i)]++;
        }
        for (int cell = 1; cell <= cells.cells(); cell++) {
            start[cell] += start[cell - 1];
        }
        for (int i = state.circles - 1; i >= 0; i--) {
            near[--start[cell(cells, i)]] = i;
        }
        for (int i = 0; i < state.circles; i++) {
            find(cells, i);
        }
    }

    private int cell(CellGrid cells, int i) {
        return cells.cell(state.circle[4 * i], state.circle[4 * i + 1]);
    }

    private void find(CellGrid cells, int i) {
        int columns = cells.columns();
        int own = cell(cells, i);
        int row = own / columns;
        int column = own - row * columns;
        for (int y = Math.max(row - 1, 0); y <= Math.min(row + 1, cells.rows() - 1); y++) {
            int end = start[y * columns + Math.min(column + 1, columns - 1) + 1];
            for (int k = start[y * columns + Math.max(column - 1, 0)]; k < end; k++) {
                if (i < near[k]) {
                    detect.pair(i, near[k], null, 0);
                }
            }
        }
    }
}
