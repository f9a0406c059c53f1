package io.github.circles2d.host;

import io.github.circles2d.IndexStrategy;
import io.github.circles2d.pipeline.Slices;
import io.github.circles2d.pipeline.WorldConfig;

/** Twin of {@code kernels/detect.cl}: finds the circles that overlap and the vector that parts them. */
final class Detect {
    private final WorldConfig config;
    private final State state;
    private final Contacts contacts;
    private final PairSource pairs;
    /** The thesis' triangle, (x, y) a pair, a slice each; empty for {@link io.github.circles2d.CollisionStore#COMPACT}. */
    private float[][] collision = {};

    Detect(WorldConfig config, State state, Contacts contacts) {
        this.config = config;
        this.state = state;
        this.contacts = contacts;
        pairs = new PairSource(config);
    }

    /** Makes the look-up tables and the triangle for as many circles as there are. */
    void prepare() {
        if (pairs.slices().circles() == state.circles || !config.strategy().pairwise()) {
            return;
        }
        collision = new float[0][];
        Slices slices = pairs.prepare(state.circles);
        float[][] made = new float[slices.count()][];
        for (int s = 0; s < made.length; s++) {
            try {
                made[s] = new float[config.triangle() ? (int) (2 * slices.pairs(s)) : 0];
            } catch (OutOfMemoryError e) {
                pairs.release();
                throw pairs.noMemory(slices, s);
            }
        }
        collision = made;
    }

    void run() {
        boolean triangle = config.triangle();
        Slices slices = pairs.slices();
        for (int s = 0; s < slices.count(); s++) {
            long first = slices.first(s);
            for (long pair = first; pair < first + slices.pairs(s); pair++) {
                long packed = pairs.pairAt(pair, first, s);
                int i = IndexStrategy.first(packed);
                int j = IndexStrategy.second(packed);
                if (triangle) {
                    int at = (int) (2 * (pair - first));
                    collision[s][at] = 0;
                    collision[s][at + 1] = 0;
                }
                pair(i, j, triangle ? collision[s] : null, (int) (2 * (pair - first)));
            }
        }
    }

    /**
     * The minimum translation vector, from i to j: as long as the overlap, along the line of centres. Goes to the
     * triangle if there is one, else to the contacts.
     */
    void pair(int i, int j, float[] triangle, int at) {
        float[] circle = state.circle;
        float dx = circle[4 * j] - circle[4 * i];
        float dy = circle[4 * j + 1] - circle[4 * i + 1];
        float reach = circle[4 * i + 2] + circle[4 * j + 2];
        float square = dx * dx + dy * dy;
        if (!(square < reach * reach)) {
            return;
        }
        float distance = (float) Math.sqrt(square);
        float depth = reach - distance;
        if (!(depth > 0)) {
            return;
        }
        float nx;
        float ny;
        if (distance > 0) {
            nx = dx / distance;
            ny = dy / distance;
        } else {
            nx = directionX(i, j);
            ny = directionY(i, j);
        }
        float x = depth * nx;
        float y = depth * ny;
        if (triangle != null) {
            triangle[at] = x;
            triangle[at + 1] = y;
        } else if (x != 0 || y != 0) {
            contacts.append(i, j, x, y);
        }
    }

    /** {@code c2d_direction}, for circles with one centre: the point (low, high half) of their hash, seen from the middle. */
    static float directionX(int i, int j) {
        int h = hash(i, j);
        return centred(h & 0xFFFF) / length(h);
    }

    /** See {@link #directionX}. */
    static float directionY(int i, int j) {
        int h = hash(i, j);
        return centred(h >>> 16) / length(h);
    }

    private static int hash(int i, int j) {
        int h = i * 0x9E3779B1 ^ j * 0x85EBCA77;
        h = (h ^ h >>> 15) * 0x2C1B3C6D;
        h = (h ^ h >>> 12) * 0x297A2D39;
        return h ^ h >>> 15;
    }

    private static float centred(int half) {
        return half - 32767.5f;
    }

    private static float length(int h) {
        float x = centred(h & 0xFFFF);
        float y = centred(h >>> 16);
        return (float) Math.sqrt(x * x + y * y);
    }

    /** The thesis' second walk over the triangle, {@code c2d_colour_collect}. */
    void collect() {
        for (int s = 0; s < collision.length; s++) {
            long first = pairs.slices().first(s);
            for (int k = 0; 2 * k < collision[s].length; k++) {
                float x = collision[s][2 * k];
                float y = collision[s][2 * k + 1];
                if (x != 0 || y != 0) {
                    long packed = pairs.pairAt(first + k, first, s);
                    contacts.append(IndexStrategy.first(packed), IndexStrategy.second(packed), x, y);
                }
            }
        }
    }
}
