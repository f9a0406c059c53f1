package io.github.circles2d.pipeline;

import io.github.circles2d.IndexStrategy;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.LongStream;

/** Which pair has which number, worked out the other way round than the library does: from (i, j) to c. */
public final class PairRule {
    private PairRule() {}

    /** First pair of row i where rows follow each other: i rows of n - 1, n - 2, ... pairs come before it. */
    public static long rowStart(int n, int i) {
        return i * (2L * n - i - 1) / 2;
    }

    /** The number of pair (i, j) in the order of a strategy. */
    public static long number(IndexStrategy strategy, int n, int i, int j) {
        return strategy == IndexStrategy.folded() ? folded(n, i, j) : rowStart(n, i) + (j - i - 1);
    }

    /** Lines of the rectangle start with a row of the upper half and end with a row of the lower half. */
    private static long folded(int n, int i, int j) {
        int lines = n / 2;
        long width = IndexStrategy.pairs(n) / lines;
        if (i < lines) {
            return i * width + (j - i - 1);
        }
        long line = 2L * lines - 1 - i;
        long end = (line + 1) * width;
        return end - (n - j);
    }

    /** Pair numbers worth a look: the ends of the triangle, of many rows and lines, and random ones. */
    public static long[] samples(int n, int count, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        long pairs = IndexStrategy.pairs(n);
        List<Long> all = new ArrayList<>(List.of(0L, 1L, pairs / 2, pairs - 2, pairs - 1));
        for (int k = 0; k < count; k++) {
            int i = k < 100 ? k % (n - 1) : k < 200 ? Math.max(0, n - 2 - (k - 100)) : random.nextInt(n - 1);
            all.add(rowStart(n, i));
            all.add(rowStart(n, i) + n - 2 - i);
            int line = random.nextInt(n / 2);
            long width = pairs / (n / 2);
            all.add(line * width);
            all.add(line * width + width - 1);
            all.add(line * width + Math.min(width - 1, n - 1L - line));
            all.add(random.nextLong(pairs));
        }
        return all.stream()
                .mapToLong(Long::longValue)
                .filter(c -> c >= 0 && c < pairs)
                .sorted()
                .distinct()
                .toArray();
    }

    /** The pairs of a table: a range, row starts included. */
    public static long[] range(long first, long pairs) {
        return LongStream.range(first, first + pairs).toArray();
    }

    /** Says what is wrong with the pair that was given for number c; null if nothing is. */
    public static String fault(IndexStrategy strategy, int n, long c, int i, int j) {
        if (!(0 <= i && i < j && j < n)) {
            return strategy + ", n = " + n + ", c = " + c + ": (" + i + ", " + j + ") is no pair";
        }
        long number = number(strategy, n, i, j);
        return number == c ? null : strategy + ", n = " + n + ", c = " + c + ": (" + i + ", " + j + ") is " + number;
    }

    /** n(n-1)/2 by numbers without a limit. */
    static BigInteger exactPairs(int n) {
        return BigInteger.valueOf(n).multiply(BigInteger.valueOf(n - 1L)).shiftRight(1);
    }
}
