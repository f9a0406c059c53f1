package io.github.circles2d.host;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Substeps;
import io.github.circles2d.pipeline.WorldConfig;

/** Twin of {@code kernels/find.cl}: lists the pairs of circles that may touch before the next detection. */
final class Find {
    private final SmallState state;
    private final SmallContacts contacts;
    private final Workers workers;
    private final Workers.Work work = this::part;
    private final PairSource pairs;
    private float horizon;
    private float fall;

    Find(WorldConfig config, SmallState state, SmallContacts contacts, Workers workers) {
        this.state = state;
        this.contacts = contacts;
        this.workers = workers;
        pairs = config.strategy().pairwise() ? new PairSource(config) : null;
    }

    void run(float newHorizon, float newFall) {
        horizon = newHorizon;
        fall = newFall;
        contacts.turn(state.levels.cells);
        if (pairs != null) {
            pairs.forEach(state.circles, this::pair);
            return;
        }
        workers.run(state.circles, work);
    }

    private void part(int part, int from, int end) {
        for (int i = from; i < end; i++) {
            neighbours(i, contacts.found[part]);
        }
    }

    /** {@code c2d_find_pair}. */
    private void pair(int i, int j) {
        int ci = SmallState.CELL * state.id[i];
        int cj = SmallState.CELL * state.id[j];
        int[] cell = state.cell;
        int at = Levels.INTS * Math.max(cell[ci + 2], cell[cj + 2]);
        int shift = state.levels.table[at + Levels.SHIFT];
        int x = cell[ci] >> shift;
        int y = cell[ci + 1] >> shift;
        int otherX = cell[cj] >> shift;
        int otherY = cell[cj + 1] >> shift;
        if (Math.abs(x - otherX) <= 1 && Math.abs(y - otherY) <= 1 && near(i, j)) {
            boolean lower = y < otherY || y == otherY && x <= otherX;
            append(
                    contacts.found[0],
                    i,
                    j,
                    lower ? state.levels.owner(at, x, y) : state.levels.owner(at, otherX, otherY));
        }
    }

    /** {@code c2d_find}: circle i looks into half of the cells around its own, and into all of those of wider levels. */
    private void neighbours(int i, SmallContacts.Found found) {
        Levels levels = state.levels;
        int c = SmallState.CELL * state.id[i];
        int own = state.cell[c + 2];
        for (int level = own; level < levels.count; level++) {
            int at = Levels.INTS * level;
            int shift = levels.table[at + Levels.SHIFT];
            int x = state.cell[c] >> shift;
            int y = state.cell[c + 1] >> shift;
            int owner = levels.owner(at, x, y);
            for (int dy = level == own ? 0 : -1; dy <= 1; dy++) {
                for (int dx = level == own && dy == 0 ? 0 : -1; dx <= 1; dx++) {
                    int otherX = x + dx;
                    int otherY = y + dy;
                    if (otherX < 0
                            || otherY < 0
                            || otherX > levels.table[at + Levels.LAST_X]
                            || otherY > levels.table[at + Levels.LAST_Y]) {
                        continue;
                    }
                    int bucket = levels.bucket(at, otherX, otherY);
                    int first = level == own && dx == 0 && dy == 0 ? i + 1 : state.bucketStart[bucket];
                    for (int j = first; j < state.bucketStart[bucket + 1]; j++) {
                        if (near(i, j) && in(j, otherX, otherY, shift)) {
                            boolean lower = dy > 0 || dy == 0 && dx >= 0;
                            append(found, i, j, lower ? owner : levels.owner(at, otherX, otherY));
                        }
                    }
                }
            }
        }
    }

    /** A bucket of a folded level holds circles of cells far apart. */
    private boolean in(int j, int x, int y, int shift) {
        int c = SmallState.CELL * state.id[j];
        return state.cell[c] >> shift == x && state.cell[c + 1] >> shift == y;
    }

    /** Whether two circles may touch within the horizon; the same whichever comes first. */
    private boolean near(int i, int j) {
        float[] body = state.body;
        int a = SmallState.BODY * i;
        int b = SmallState.BODY * j;
        float dx = body[a] - body[b];
        float dy = body[a + 1] - body[b + 1];
        float dvx = body[a + 2] - body[b + 2];
        float dvy = body[a + 3] - body[b + 3];
        float ra = body[a + SmallState.RADIUS];
        float rb = body[b + SmallState.RADIUS];
        float travel = (float) Math.sqrt(dvx * dvx + dvy * dvy) * horizon;
        float smaller = ra < rb ? ra : rb;
        float reach = ra + rb + state.number(Substeps.ALWAYS_NEAR) * smaller + fall + travel;
        return dx * dx + dy * dy < reach * reach;
    }

    private void append(SmallContacts.Found found, int i, int j, int owner) {
        boolean inOrder = state.id[i] < state.id[j];
        found.append(inOrder ? i : j, inOrder ? j : i, owner);
    }
}
