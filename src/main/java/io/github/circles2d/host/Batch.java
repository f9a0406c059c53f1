package io.github.circles2d.host;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Status;
import io.github.circles2d.pipeline.Tiles;
import java.util.Arrays;

/** Twin of {@code kernels/batch.cl}: puts the contacts in the order in which they are solved. */
final class Batch {
    /** Of the colours of which a circle has a mask, those for the first tiling: {@code C2D_FIRST_COLOURS}. */
    private static final long FIRST_COLOURS = 0xFFFFFFFFL;

    private final SmallState state;
    private final SmallContacts contacts;
    private final Workers workers;
    private final Workers.Work sort = this::sort;
    private final Workers.Work colour = this::colour;
    private final Workers.Work sortTiles = this::order;
    private Levels levels;
    /** Whose tiles are shared out. */
    private int tiling;

    private Tiles tiles;
    /** Of the pass: where the level begins in the table, what column and row of a bucket leave, how many rows are apart. */
    private int at;

    private int x;
    private int y;
    private int rows;

    /** By circle: the colours of its contacts, and how many beyond those of the mask. */
    private long[] mask = {};

    private int[] beyond = {};
    /** By contact: its circle in whose list it is, its tile, its colour. */
    int[] owner = {};

    private int[] tileOf = {};
    private int[] tint = {};
    /** By tile: the colour and then the contact. */
    private long[] keys = {};
    /** In the order of solving: the contact. */
    int[] order = {};

    private int[] tileStart = {0};

    Batch(SmallState state, SmallContacts contacts, Workers workers) {
        this.state = state;
        this.contacts = contacts;
        this.workers = workers;
    }

    void run() {
        ready(contacts.listStart[state.circles]);
        workers.run(state.circles, sort);
        colours();
        byTile(contacts.listStart[state.circles]);
        for (int which = 0; which < tiles.tilings; which++) {
            forTiles(which, sortTiles);
        }
    }

    private void ready(int count) {
        if (levels != state.levels) {
            levels = state.levels;
            tiles = Tiles.of(levels);
            tileStart = new int[tiles.tiles + 1];
        }
        Arrays.fill(tileStart, 0);
        if (mask.length < state.id.length) {
            mask = new long[state.id.length];
            beyond = new int[state.id.length];
        }
        Arrays.fill(mask, 0, state.circles, 0);
        Arrays.fill(beyond, 0, state.circles, 0);
        if (order.length < count) {
            int room = contacts.other.length;
            owner = new int[room];
            tileOf = new int[room];
            tint = new int[room];
            keys = new long[room];
            order = new int[room];
        }
    }

    /** {@code c2d_batch_count}, what it finds out of each contact. */
    private void sort(int part, int from, int end) {
        for (int i = from; i < end; i++) {
            for (int k = contacts.listStart[i]; k < contacts.listStart[i + 1]; k++) {
                owner[k] = i;
                tileOf[k] = tile(i, contacts.other[k]);
            }
        }
    }

    private int tile(int i, int j) {
        int which = 0;
        int tile = tiles.tile(0, state.column(i), state.row(i));
        while (tile != tiles.tile(which, state.column(j), state.row(j))) {
            which++;
            tile = tiles.tile(which, state.column(i), state.row(i));
        }
        return tile;
    }

    /** {@code c2d_batch_colour}: of each level a colour of buckets at a time, which share no circle. */
    private void colours() {
        for (int number = 0; number < levels.count; number++) {
            at = Levels.at(number);
            rows = Levels.rows(number);
            int circles = state.bucketStart[firstBucket() + buckets()] - state.bucketStart[firstBucket()];
            for (int which = 0; which < 3 * rows; which++) {
                x = which % 3;
                y = which / 3;
                workers.run(circles, colour);
            }
        }
    }

    private int firstBucket() {
        return levels.table[at + Levels.BASE];
    }

    private int buckets() {
        return levels.table[at + Levels.WIDTH] * levels.table[at + Levels.HEIGHT];
    }

    /** The buckets of the colour that begin with circles {@code from .. end - 1} of the level. */
    private void colour(int part, int from, int end) {
        int width = levels.table[at + Levels.WIDTH];
        int first = firstBucket();
        int low = search(state.bucketStart, first, first + buckets(), from) - first;
        int high = search(state.bucketStart, first, first + buckets(), end) - first;
        for (int row = low / width; row * width < high; row++) {
            if (row % rows != y) {
                continue;
            }
            int column = Math.max(0, low - row * width);
            column += Math.floorMod(x - column, 3);
            for (; column < Math.min(width, high - row * width); column += 3) {
                int bucket = first + row * width + column;
                for (int i = state.bucketStart[bucket]; i < state.bucketStart[bucket + 1]; i++) {
                    colour(i);
                }
            }
        }
    }

    private void colour(int i) {
        for (int k = contacts.listStart[i]; k < contacts.listStart[i + 1]; k++) {
            int j = contacts.other[k];
            long usable = tileOf[k] < tiles.first(1) ? FIRST_COLOURS : ~FIRST_COLOURS;
            long lowest = Long.lowestOneBit(~(mask[i] | mask[j]) & usable);
            tint[k] = Long.numberOfTrailingZeros(lowest);
            mask[i] |= lowest;
            mask[j] |= lowest;
            if (lowest == 0) {
                int next = Math.max(beyond[i], beyond[j]) + 1;
                beyond[i] = next;
                beyond[j] = next;
                tint[k] += next - 1;
                if (tint[k] > Status.MOST_COLOURS) {
                    throw Status.tooDense();
                }
            }
        }
    }

    /** {@code c2d_batch_fill}. */
    private void byTile(int count) {
        for (int k = 0; k < count; k++) {
            tileStart[tileOf[k]]++;
        }
        for (int tile = 1; tile <= tiles.tiles; tile++) {
            tileStart[tile] += tileStart[tile - 1];
        }
        for (int k = count - 1; k >= 0; k--) {
            keys[--tileStart[tileOf[k]]] = (long) tint[k] << 31 | k;
        }
    }

    /** {@code c2d_batch_order}: the tiles of a tiling that begin with contacts {@code from .. end - 1} of it. */
    private void order(int part, int from, int end) {
        int last = tileFrom(end);
        for (int tile = tileFrom(from); tile < last; tile++) {
            Arrays.sort(keys, tileStart[tile], tileStart[tile + 1]);
            for (int e = tileStart[tile]; e < tileStart[tile + 1]; e++) {
                order[e] = (int) keys[e] & Integer.MAX_VALUE;
            }
        }
    }

    /** Shares out the tiles of a tiling by their contacts. */
    void forTiles(int which, Workers.Work work) {
        tiling = which;
        workers.run(tileStart[tiles.first(which + 1)] - tileStart[tiles.first(which)], work);
    }

    int tilings() {
        return tiles.tilings;
    }

    /** Where in the order the tiles begin that the parts of the work do. */
    int start(int contact) {
        return tileStart[tileFrom(contact)];
    }

    /** The first tile of the tiling that begins with contact {@code contact} of it, or with a later one. */
    private int tileFrom(int contact) {
        return search(tileStart, tiles.first(tiling), tiles.first(tiling + 1), contact);
    }

    /** The first of {@code low .. high} that begins with item {@code item} of those of {@code low}, or with a later one. */
    private static int search(int[] start, int low, int high, int item) {
        int from = low;
        int to = high;
        int wanted = start[low] + item;
        while (from < to) {
            int middle = from + (to - from) / 2;
            if (start[middle] < wanted) {
                from = middle + 1;
            } else {
                to = middle;
            }
        }
        return from;
    }
}
