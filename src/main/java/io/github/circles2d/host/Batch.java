package io.github.circles2d.host;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Status;
import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.Workers;
import java.util.Arrays;

/** Twin of {@code kernels/batch.cl}: puts the contacts in the order in which they are solved. */
final class Batch {
    private final SmallState state;
    private final SmallContacts contacts;
    private final Workers workers;
    private final Workers.Work sort = this::sort;
    private final Workers.Work forTile = this::tiles;
    private Levels levels;
    /** Whose tiles are shared out. */
    private int tiling;

    private Tiles tiles;
    /** By circle: the colours of its contacts in its tile, and how many beyond those of the mask. */
    private long[] mask = {};

    private int[] beyond = {};
    /** By contact: its circle in whose list it is, its tile, its class. */
    private int[] owner = {};

    private int[] tileOf = {};
    private short[] classOf = {};
    /** By tile: the colour and then the contact. */
    private long[] keys = {};
    /** By tile: the contact. */
    private int[] order = {};
    /** In the order of solving: the places of the two circles. */
    int[] pairs = {};

    private int[] tileStart = {0};

    Batch(SmallState state, SmallContacts contacts, Workers workers) {
        this.state = state;
        this.contacts = contacts;
        this.workers = workers;
    }

    void run() {
        ready(contacts.listStart[state.circles]);
        workers.run(state.circles, sort);
        byTile(contacts.listStart[state.circles]);
        for (int which = 0; which < tiles.tilings; which++) {
            Arrays.fill(mask, 0, state.circles, 0);
            Arrays.fill(beyond, 0, state.circles, 0);
            forTiles(which, forTile);
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
        if (order.length < count) {
            int room = contacts.other.length;
            owner = new int[room];
            tileOf = new int[room];
            classOf = new short[room];
            keys = new long[room];
            order = new int[room];
            pairs = new int[2 * room];
        }
    }

    /** {@code c2d_batch_count}, what it finds out of each contact. */
    private void sort(int part, int from, int end) {
        for (int i = from; i < end; i++) {
            short own = contacts.listStart[i] < contacts.listStart[i + 1] ? classOf(i) : 0;
            for (int k = contacts.listStart[i]; k < contacts.listStart[i + 1]; k++) {
                owner[k] = i;
                tileOf[k] = tile(i, contacts.other[k]);
                classOf[k] = own;
            }
        }
    }

    /** {@code c2d_batch_code}, of the bucket of a circle its class. */
    private short classOf(int i) {
        int number = levels.levelOf(state.body[SmallState.BODY * i + SmallState.RADIUS]);
        int at = Levels.at(number);
        int shift = levels.table[at + Levels.SHIFT];
        int x = (state.column(i) >> shift) % 3;
        int y = (state.row(i) >> shift) % Levels.rows(number);
        return (short) ((number == 0 ? 0 : 9 * number - 3) + 3 * y + x);
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

    /** {@code c2d_batch_fill}. */
    private void byTile(int count) {
        for (int k = 0; k < count; k++) {
            tileStart[tileOf[k]]++;
        }
        for (int tile = 1; tile <= tiles.tiles; tile++) {
            tileStart[tile] += tileStart[tile - 1];
        }
        for (int k = count - 1; k >= 0; k--) {
            order[--tileStart[tileOf[k]]] = k;
        }
    }

    /** The tiles of a tiling that begin with contacts {@code from .. end - 1} of it. */
    private void tiles(int part, int from, int end) {
        int last = tileFrom(end);
        for (int tile = tileFrom(from); tile < last; tile++) {
            tint(tileStart[tile], tileStart[tile + 1]);
            Arrays.sort(keys, tileStart[tile], tileStart[tile + 1]);
            for (int e = tileStart[tile]; e < tileStart[tile + 1]; e++) {
                int k = (int) keys[e] & Integer.MAX_VALUE;
                contacts.where[k] = e;
                pairs[2 * e] = owner[k];
                pairs[2 * e + 1] = contacts.other[k];
            }
        }
    }

    /** {@code c2d_batch_colour}, of the tile that has contacts {@code from .. end - 1}: a class after the other. */
    private void tint(int from, int end) {
        int next = 0;
        for (int now = 0; now < Integer.MAX_VALUE; now = next) {
            next = Integer.MAX_VALUE;
            for (int e = from; e < end; e++) {
                int k = order[e];
                if (classOf[k] == now) {
                    keys[e] = (long) colour(owner[k], contacts.other[k]) << 31 | k;
                } else if (classOf[k] > now) {
                    next = Math.min(next, classOf[k]);
                }
            }
        }
    }

    private int colour(int i, int j) {
        long lowest = Long.lowestOneBit(~(mask[i] | mask[j]));
        mask[i] |= lowest;
        mask[j] |= lowest;
        int colour = Long.numberOfTrailingZeros(lowest);
        if (lowest == 0) {
            int next = Math.max(beyond[i], beyond[j]) + 1;
            beyond[i] = next;
            beyond[j] = next;
            colour += next - 1;
            if (colour > Status.MOST_COLOURS) {
                throw Status.tooDense();
            }
        }
        return colour;
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
