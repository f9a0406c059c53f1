package io.github.circles2d.host;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Substeps;
import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.WorldConfig;
import java.util.Arrays;

/** Twin of {@code kernels/batch.cl}: puts the contacts in the order in which they are solved. */
public final class Batch {
    private static final int COLOURS = 32;

    private final WorldConfig config;
    private final SmallState state;
    private final SmallContacts contacts;
    private long[] keys = {};
    private int[] mask = {};
    private int[] tileOf = {};
    private int[] lists = {};
    int[] order = {};
    int[] owner = {};
    int[] tileStart = {};
    Tiles tiles;
    Levels of;
    public static long sumColours, sumTiles, maxColours, sumDepth, maxDepth; public static int[] perTiling=new int[30];
    int[] depth={};

    Batch(WorldConfig config, SmallState state, SmallContacts contacts) {
        this.config = config;
        this.state = state;
        this.contacts = contacts;
    }

    void run() {
        if (of != state.levels) {
            of = state.levels;
            tiles = Tiles.of(of);
        }
        int n = contacts.listStart[state.circles];
        if (order.length < n) {
            order = new int[2 * n];
            owner = new int[2 * n];
            keys = new long[2 * n];
            tileOf = new int[2 * n];
        }
        if (mask.length < state.circles) { mask = new int[state.id.length]; depth = new int[state.id.length]; }
        tileStart = new int[tiles.tiles + 1];
        for (int i = 0; i < state.circles; i++) {
            for (int k = contacts.listStart[i]; k < contacts.listStart[i + 1]; k++) {
                owner[k] = i;
                tileOf[k] = tile(i, contacts.other[k]);
                tileStart[tileOf[k] + 1]++;
            }
        }
        for (int t = 1; t <= tiles.tiles; t++) {
            tileStart[t] += tileStart[t - 1];
        }
        int[] cursor = tileStart.clone();
        for (int k = 0; k < n; k++) {
            keys[cursor[tileOf[k]]++] = (k * 0x9E3779B1L & 0xFFFFFFFFL) << 31 | k;
        }
        int[] colour = new int[n];
        for (int t = 0; t < tiles.tiles; t++) {
            int a = tileStart[t], b = tileStart[t + 1];
            if (a == b) continue;
            Arrays.sort(keys, a, b);
            for (int e = a; e < b; e++) {
                int k = (int) (keys[e] & 0x7FFFFFFF);
                mask[owner[k]] = 0; mask[contacts.other[k]] = 0; depth[owner[k]]=0; depth[contacts.other[k]]=0;
            }
            int most = 0;int dm=0;
            for (int e = a; e < b; e++) {
                int k = (int) (keys[e] & 0x7FFFFFFF);
                int i = owner[k], j = contacts.other[k];
                int c = Integer.numberOfTrailingZeros(~(mask[i] | mask[j]));
                mask[i] |= 1 << c; mask[j] |= 1 << c;
                int d=Math.max(depth[i],depth[j])+1; depth[i]=d; depth[j]=d; dm=Math.max(d,dm);
                keys[e] = (long) c << 31 | k;
                most = Math.max(most, c + 1);
            }
            Arrays.sort(keys, a, b);
            sumColours += most; sumTiles++; maxColours = Math.max(maxColours, most);sumDepth+=dm; maxDepth=Math.max(maxDepth,dm);
            for (int e = a; e < b; e++) order[e] = (int) (keys[e] & 0x7FFFFFFF);
        }
        for (int p=0;p<tiles.tilings;p++) perTiling[p]+=tileStart[tiles.first(p+1)]-tileStart[tiles.first(p)];
    }

    private int tile(int i, int j) {
        int xi = state.levels.column(state.body[SmallState.BODY * i], config.minX());
        int yi = state.levels.row(state.body[SmallState.BODY * i + 1], config.minY());
        int xj = state.levels.column(state.body[SmallState.BODY * j], config.minX());
        int yj = state.levels.row(state.body[SmallState.BODY * j + 1], config.minY());
        for (int tiling = 0; tiling < tiles.tilings; tiling++) {
            int t = tiles.tile(tiling, xi, yi);
            if (t == tiles.tile(tiling, xj, yj)) return t;
        }
        throw new IllegalStateException("no tile holds both " + xi + " " + xj + " " + yi + " " + yj);
    }
}
