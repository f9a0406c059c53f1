package io.github.circles2d;

import io.github.circles2d.pipeline.IndexStrategies;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.stream.Stream;

/**
 * How a work-item finds its pair of circles (thesis, chapter 4, "MTV buffer design").
 *
 * <p>The pairs of {@code n} circles are numbered c = 0 .. n(n-1)/2 - 1. A strategy maps c to a pair (i, j),
 * 0 <= i < j < n, one to one; in which order is its own affair: it never changes the result of a step, only its time.
 * Five are built in; implement the interface to add one. {@code n} goes up to 2^31 - 1, c is 64 bits wide.
 *
 * <p>The OpenCL source runs with the rights of the process, like any native code: take it from people you trust.
 * Implementations are immutable.
 */
public interface IndexStrategy {
    /** A short name, unique among the strategies in use. */
    String name();

    /**
     * Whether the strategy numbers the pairs, as all do but {@link #grid()}. Where it does not, circles look for their
     * neighbours in a grid of cells, and no other method but {@link #name()} is called.
     */
    default boolean pairwise() {
        return true;
    }

    /**
     * OpenCL C 1.2 that defines
     *
     * <pre>{@code
     * static int2 c2d_pair_at(c2d_index pair, c2d_index first, int circles, __global const int2 *table)
     * }</pre>
     *
     * where {@code c2d_index} is {@code uint}, or {@code ulong} where there are more than 2^31 - 1 pairs
     * ({@code C2D_WIDE} is 1 then), {@code first} the first pair that {@code table} serves, and {@code table} the bytes of
     * {@link #fillTable}. Called for {@code circles >= 2} only.
     */
    String kernelSource();

    /**
     * Bytes of the look-up table that serves {@code pairs} pairs in a row; 0 for a strategy without one.
     *
     * @param circles number of circles, 2 to 2^31 - 1
     * @param pairs how many pairs, 1 to n(n-1)/2
     */
    default long tableBytes(int circles, long pairs) {
        return 0;
    }

    /**
     * Writes the table for the pairs {@code first .. first + pairs - 1}.
     *
     * @param table empty, of {@link #tableBytes} bytes, in the device's byte order; written from position 0
     */
    default void fillTable(int circles, long first, long pairs, ByteBuffer table) {}

    /**
     * The same mapping in Java; the arguments are those of the kernel's function.
     *
     * @param pair a pair, {@code first} to n(n-1)/2 - 1
     * @param table what {@link #fillTable} wrote
     * @return i and j, as {@link #pack} packs them
     */
    long pairAt(long pair, long first, int circles, ByteBuffer table);

    /** Number of pairs of {@code circles} circles: n(n-1)/2. Exact for every non-negative int. */
    static long pairs(int circles) {
        return (long) circles * (circles - 1L) / 2;
    }

    /** A pair in one long: {@code i} in the high half, {@code j} in the low half. */
    static long pack(int i, int j) {
        return (long) i << 32 | j & 0xFFFFFFFFL;
    }

    /** The first of a packed pair. */
    static int first(long packed) {
        return (int) (packed >> 32);
    }

    /** The second of a packed pair. */
    static int second(long packed) {
        return (int) packed;
    }

    /**
     * Strategy 0 of the thesis: from a square root, followed by an exact correction in integers. Without it, the
     * thesis' formula misses pairs from 2,116 circles on, and runs out of the buffer at 5,000.
     */
    static IndexStrategy formula() {
        return IndexStrategies.FORMULA;
    }

    /** Strategy 1 of the thesis: from a table of all pairs, 4 bytes a pair, 8 beyond 65,536 circles. */
    static IndexStrategy pairTable() {
        return IndexStrategies.PAIR_TABLE;
    }

    /** Strategy 2 of the thesis: by binary search in a table of the first and last pair of each row. */
    static IndexStrategy rowSearch() {
        return IndexStrategies.ROW_SEARCH;
    }

    /** The triangle folded into a rectangle: one integer division, no table, no root. */
    static IndexStrategy folded() {
        return IndexStrategies.FOLDED;
    }

    /**
     * No pairs at all: circles are sorted into square cells, and each looks into the cells around its own. The others
     * take time that grows with the square of the number of circles, this one with the number.
     *
     * <p>It finds the contacts that they find, and so gives the same result. It has no pair index: {@link #pairwise()} is
     * false, {@link #pairAt} throws, and there is nothing for a {@link CollisionStore#TRIANGLE} to hold, so that contacts
     * go to the compact list.
     *
     * <p>The cells are those that own the contacts. Under {@link Solver#IMPULSE} they are as wide as the largest circle.
     * Under {@link Solver#SMALL_STEPS} they come in levels, each twice as wide as the last, a circle lies in the level
     * that fits its radius, and looks into its own level and into every wider one: radii may differ by any factor. A
     * counting sort by cell (histogram, scan, scatter), then by number within a cell, makes the order of the circles
     * independent of who came first.
     */
    static IndexStrategy grid() {
        return IndexStrategies.GRID;
    }

    /**
     * The fastest of the built-in strategies for the device, the solver and the {@link Circles2D.Builder#capacity capacity} of
     * a world, found by short trials when it is built (the thesis' outlook, chapter 6: to pick the structure for the device
     * at run time). Whether a small world is done by one work-group is tried too. The choice is kept for worlds of the same
     * kind, up to a factor of two in capacity, as long as the process lives: the first such world takes up to a few seconds
     * to build, mostly to compile kernels. It never changes the result.
     */
    static IndexStrategy auto() {
        return IndexStrategies.AUTO;
    }

    /** The built-in strategies, {@link #auto()} left out. */
    static List<IndexStrategy> builtIn() {
        return List.of(formula(), pairTable(), rowSearch(), grid(), folded());
    }

    /**
     * The built-in strategy of a name, or {@link #auto()}.
     *
     * @throws IllegalArgumentException if there is none; the message lists them
     */
    static IndexStrategy named(String name) {
        List<IndexStrategy> known =
                Stream.concat(builtIn().stream(), Stream.of(auto())).toList();
        return known.stream()
                .filter(strategy -> strategy.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("strategy = " + name + ": must be one of "
                        + known.stream().map(IndexStrategy::name).toList()));
    }
}
