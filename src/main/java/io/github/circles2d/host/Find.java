package io.github.circles2d.host;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Substeps;
import io.github.circles2d.pipeline.Workers;
import io.github.circles2d.pipeline.WorldConfig;
import java.util.Arrays;

/** Twin of {@code kernels/find.cl}: lists the pairs of circles that may touch before the next detection. */
final class Find {
    /** Beyond what rounding may take from a sum of five. */
    private static final float ROUNDING = 1.00001f;

    private final SmallState state;
    private final SmallContacts contacts;
    private final Workers workers;
    private final Workers.Work search = this::search;
    private final Workers.Work fill = this::fill;
    private final PairSource.PairAction pair = this::pair;
    private final PairSource pairs;
    /** Of each part: contacts listed with the circle that found them, in order; and the others. */
    private final SmallContacts.Found[] own;

    private final SmallContacts.Found[] listed;
    /** How many contacts each circle found that are listed with it. */
    private int[] owns = {};

    private float horizon;
    private float slack;
    private float always;

    Find(WorldConfig config, SmallState state, SmallContacts contacts, Workers workers) {
        this.state = state;
        this.contacts = contacts;
        this.workers = workers;
        pairs = config.strategy().pairwise() ? new PairSource(config) : null;
        own = new SmallContacts.Found[workers.most()];
        listed = new SmallContacts.Found[workers.most()];
        Arrays.setAll(own, part -> new SmallContacts.Found());
        Arrays.setAll(listed, part -> new SmallContacts.Found());
    }

    void run(float newHorizon, float newSlack) {
        horizon = newHorizon;
        slack = newSlack;
        always = state.number(Substeps.ALWAYS_NEAR);
        contacts.turn();
        if (owns.length < state.id.length) {
            owns = new int[state.id.length];
        }
        for (int part = 0; part < own.length; part++) {
            own[part].count = 0;
            listed[part].count = 0;
        }
        if (pairs != null) {
            Arrays.fill(owns, 0, state.circles, 0);
            pairs.forEach(state.circles, pair);
        } else {
            workers.runUneven(state.circles, search);
        }
        lay();
        // cut as for the search: each part fills in what it has found
        workers.runUneven(state.circles, fill);
    }

    /** Where each list begins; then what others have found for it, at its start, in the order of their places. */
    private void lay() {
        int[] start = contacts.listStart;
        start[0] = 0;
        System.arraycopy(owns, 0, start, 1, state.circles);
        for (SmallContacts.Found found : listed) {
            for (int k = 0; k < found.count; k++) {
                start[found.lists[k] + 1]++;
            }
        }
        contacts.lay(state.circles);
        // from the last to the first, downwards from where the circle's own begin
        for (int part = listed.length - 1; part >= 0; part--) {
            SmallContacts.Found found = listed[part];
            for (int k = found.count - 1; k >= 0; k--) {
                int i = found.lists[k];
                owns[i]++;
                contacts.other[start[i + 1] - owns[i]] = found.other[k];
            }
        }
        if (pairs != null) {
            for (int i = 0; i < state.circles; i++) {
                Arrays.sort(contacts.other, start[i], start[i + 1]);
                owns[i] = 0;
            }
        }
    }

    private void search(int part, int from, int end) {
        for (int i = from; i < end; i++) {
            int before = own[part].count;
            around(i, own[part], listed[part]);
            owns[i] = own[part].count - before;
        }
    }

    /** Copies what circles have found for themselves to the ends of their lists. */
    private void fill(int part, int from, int end) {
        SmallContacts.Found found = own[part];
        int k = 0;
        for (int i = from; k < found.count; i++) {
            int first = k;
            while (k < found.count && found.lists[k] == i) {
                k++;
            }
            System.arraycopy(found.other, first, contacts.other, contacts.listStart[i + 1] - (k - first), k - first);
        }
    }

    /** {@code c2d_find_pair}. */
    private void pair(int i, int j) {
        if (!near(state.body, SmallState.BODY * i, SmallState.BODY * j)) {
            return;
        }
        Levels levels = state.levels;
        int a = levels.levelOf(radius(i));
        int b = levels.levelOf(radius(j));
        int shift = levels.table[Levels.at(Math.max(a, b)) + Levels.SHIFT];
        int dx = (state.column(i) >> shift) - (state.column(j) >> shift);
        int dy = (state.row(i) >> shift) - (state.row(j) >> shift);
        if (Math.abs(dx) > 1 || Math.abs(dy) > 1) {
            return;
        }
        boolean lower = dy < 0 || dy == 0 && (dx < 0 || dx == 0 && i < j);
        boolean first = a > b || a == b && lower;
        listed[0].append(first ? j : i, first ? i : j);
    }

    /** {@code c2d_find_around}, from the first to the last. */
    private void around(int i, SmallContacts.Found ownFound, SmallContacts.Found listedFound) {
        Levels levels = state.levels;
        int home = levels.levelOf(radius(i));
        for (int number = home; number < levels.count; number++) {
            int at = Levels.at(number);
            int shift = levels.table[at + Levels.SHIFT];
            int x = state.column(i) >> shift;
            int y = state.row(i) >> shift;
            boolean same = number == home;
            boolean folded = levels.folded(at);
            SmallContacts.Found found = same ? ownFound : listedFound;
            int lastRow = Math.min(y + 1, levels.table[at + Levels.LAST_Y]);
            int lastColumn = Math.min(x + 1, levels.table[at + Levels.LAST_X]);
            int begin = found.count;
            for (int row = same ? y : Math.max(y - 1, 0); row <= lastRow; row++) {
                boolean own = same && row == y;
                int column = own ? x : Math.max(x - 1, 0);
                while (column <= lastColumn) {
                    // cells of a row are next to each other, save where the level is folded
                    int to = folded ? column : lastColumn;
                    int first = own && column == x ? i + 1 : state.bucketStart[levels.bucket(at, column, row)];
                    int end = state.bucketStart[levels.bucket(at, to, row) + 1];
                    int before = found.count;
                    among(first, end, i, same, found);
                    if (folded) {
                        // a bucket holds circles of cells far apart
                        keep(column, row, shift, before, same, found);
                    }
                    column = to + 1;
                }
            }
            if (folded && same) {
                Arrays.sort(found.other, begin, found.count);
            }
        }
    }

    /** Circle i and those from {@code first} to {@code end}. */
    private void among(int first, int end, int i, boolean same, SmallContacts.Found found) {
        float[] body = state.body;
        int a = SmallState.BODY * i;
        float x = body[a];
        float y = body[a + 1];
        float vx = body[a + 2];
        float vy = body[a + 3];
        float radius = body[a + SmallState.RADIUS];
        float still = radius + slack;
        float more = always * radius;
        for (int j = first, b = SmallState.BODY * first; j < end; j++, b += SmallState.BODY) {
            float dx = x - body[b];
            float dy = y - body[b + 1];
            float travel = (Math.abs(vx - body[b + 2]) + Math.abs(vy - body[b + 3])) * horizon;
            // most are farther apart than this, which needs no root, and no guess which of the two is smaller
            float reach = (still + body[b + SmallState.RADIUS] + more + travel) * ROUNDING;
            if (dx * dx + dy * dy < reach * reach && near(body, a, b)) {
                found.append(same ? j : i, same ? i : j);
            }
        }
    }

    /** Of the contacts found since there were {@code before}, keeps those with circles of one cell. */
    private void keep(int column, int row, int shift, int before, boolean same, SmallContacts.Found found) {
        int count = before;
        for (int k = before; k < found.count; k++) {
            int j = same ? found.other[k] : found.lists[k];
            if (state.column(j) >> shift == column && state.row(j) >> shift == row) {
                found.other[count] = found.other[k];
                found.lists[count] = found.lists[k];
                count++;
            }
        }
        found.count = count;
    }

    private float radius(int i) {
        return state.body[SmallState.BODY * i + SmallState.RADIUS];
    }

    /** {@code c2d_near}, of the circles at {@code a} and {@code b} of the bodies. */
    private boolean near(float[] body, int a, int b) {
        float dx = body[a] - body[b];
        float dy = body[a + 1] - body[b + 1];
        float dvx = body[a + 2] - body[b + 2];
        float dvy = body[a + 3] - body[b + 3];
        float ra = body[a + SmallState.RADIUS];
        float rb = body[b + SmallState.RADIUS];
        float travel = (float) Math.sqrt(dvx * dvx + dvy * dvy) * horizon;
        float smaller = ra < rb ? ra : rb;
        float reach = ra + rb + always * smaller + slack + travel;
        return dx * dx + dy * dy < reach * reach;
    }
}
