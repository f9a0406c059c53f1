package io.github.circles2d.host;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.WorldConfig;
import java.util.Arrays;

/** Twin of {@code kernels/batch.cl}: puts the contacts in the order in which they are solved. */
final class Batch {
    /** Colours of which a circle has a mask: {@code C2D_COLOURS}. */
    private static final int COLOURS = 32;

    private final WorldConfig config;
    private final SmallState state;
    private final SmallContacts contacts;
    private final Workers workers;
    private final Workers.Work sort = this::sort;
    private final Workers.Work colour = this::colour;
    private Levels levels;
    /** Whose tiles are shared out. */
    private int tiling;

    private Tiles tiles;
    /** Of each part of the work: the counts of the colours, and of what is left for later ones. */
    private final int[][] counts;

    /** By circle: the colours of its contacts in this tile. */
    private int[] mask = {};
    /** By contact: its circle in whose list it is, its tile, its colour. */
    int[] owner = {};

    private int[] tileOf = {};
    private byte[] tint = {};
    /** By tile: what contacts are coloured in order of, the priority and then the contact. */
    private long[] keys = {};
    /** In the order of solving: the contact. */
    int[] order = {};

    private int[] tileStart = {0};

    Batch(WorldConfig config, SmallState state, SmallContacts contacts, Workers workers) {
        this.config = config;
        this.state = state;
        this.contacts = contacts;
        this.workers = workers;
        counts = new int[workers.most()][COLOURS + 1];
    }

    void run() {
        ready(contacts.listStart[state.circles]);
        workers.run(state.circles, sort);
        byTile(contacts.listStart[state.circles]);
        for (int tiling = 0; tiling < tiles.tilings; tiling++) {
            forTiles(tiling, colour);
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
            mask = new int[state.id.length];
        }
        if (order.length < count) {
            int room = contacts.other.length;
            owner = new int[room];
            tileOf = new int[room];
            tint = new byte[room];
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
        int ax = levels.column(x(i), config.minX());
        int ay = levels.row(y(i), config.minY());
        int bx = levels.column(x(j), config.minX());
        int by = levels.row(y(j), config.minY());
        int tiling = 0;
        int tile = tiles.tile(0, ax, ay);
        while (tile != tiles.tile(tiling, bx, by)) {
            tiling++;
            tile = tiles.tile(tiling, ax, ay);
        }
        return tile;
    }

    private float x(int i) {
        return state.body[SmallState.BODY * i + SmallState.X];
    }

    private float y(int i) {
        return state.body[SmallState.BODY * i + SmallState.Y];
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
            keys[--tileStart[tileOf[k]]] = priority(k) << 31 | k;
        }
    }

    /** {@code c2d_priority}: contacts that lie rather than stand come first. */
    private long priority(int k) {
        int i = owner[k];
        int j = contacts.other[k];
        boolean stands = Math.abs(y(i) - y(j)) >= Math.abs(x(i) - x(j));
        return (k * 0x9E3779B1L & 0x7FFFFFFF) | (stands ? 1L << 31 : 0);
    }

    /** The tiles of a tiling that begin with contacts {@code from .. end - 1} of it, {@code c2d_batch_colour}. */
    private void colour(int part, int from, int end) {
        for (int tile = tileFrom(from); tile < tileFrom(end); tile++) {
            int done = tileStart[tile];
            int last = tileStart[tile + 1];
            Arrays.sort(keys, done, last);
            for (int e = done; e < last; e++) {
                tint[contact(e)] = COLOURS;
            }
            for (int e = done; done < last; e = tileStart[tile]) {
                done = page(counts[part], e, last, done);
            }
        }
    }

    private int contact(int e) {
        return (int) keys[e] & Integer.MAX_VALUE;
    }

    /** Gives contacts {@code first .. end - 1} that have no colour one of the next; {@code done} have a place in the order. */
    private int page(int[] count, int first, int end, int done) {
        Arrays.fill(count, 0);
        for (int e = first; e < end; e++) {
            int k = contact(e);
            if (tint[k] == COLOURS) {
                mask[owner[k]] = 0;
                mask[contacts.other[k]] = 0;
            }
        }
        for (int e = first; e < end; e++) {
            int k = contact(e);
            if (tint[k] == COLOURS) {
                int i = owner[k];
                int j = contacts.other[k];
                int lowest = Integer.lowestOneBit(~(mask[i] | mask[j]));
                mask[i] |= lowest;
                mask[j] |= lowest;
                tint[k] = (byte) Integer.numberOfTrailingZeros(lowest);
                count[tint[k]]++;
            }
        }
        int start = done;
        for (int c = 0; c < COLOURS; c++) {
            int own = count[c];
            count[c] = start;
            start += own;
        }
        for (int e = first; e < end; e++) {
            int k = contact(e);
            if (tint[k] >= 0 && tint[k] < COLOURS) {
                order[count[tint[k]]++] = k;
                tint[k] = -1;
            }
        }
        return start;
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
        int low = tiles.first(tiling);
        int high = tiles.first(tiling + 1);
        int wanted = tileStart[low] + contact;
        while (low < high) {
            int middle = low + (high - low) / 2;
            if (tileStart[middle] < wanted) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }
}
