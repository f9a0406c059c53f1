package io.github.circles2d.bench;

import java.util.stream.IntStream;

/**
 * Lays circles of similar sizes out in a box, as if dropped one by one: each comes to rest where the surface is low, on two that lie
 * already or on one and a wall, with its centre between them, touching and not overlapping. See {@link Layout#packed}.
 */
final class Packing {
    /** The surface is kept as the highest so many circles of each column; columns are as wide as the largest radius, or wider. */
    private static final int KEPT = 16;

    /** Columns on each side in which a circle may touch another. */
    private static final int REACH = 3;

    /** Beyond this number the box is cut into strips, so that several threads can fill it. */
    private static final int STRIP = 60_000;

    private final float[] radius;
    private final float[] x;
    private final float[] y;
    private final double minX;
    private final double maxX;
    private final double largest;
    private final double gap;
    private final int columns;
    private final int[] surface;
    private final int[] kept;

    // the circles that the next one can meet
    private final int[] near = new int[KEPT * (2 * REACH + 1)];
    private int nears;

    // the column that is to be filled, and where the next circle comes to rest in it
    private int filling;
    private double top;
    private double bestX;
    private double bestY;

    private Packing(float[] radius, float[] x, float[] y, double minX, double maxX, double largest) {
        this.radius = radius;
        this.x = x;
        this.y = y;
        this.minX = minX;
        this.maxX = maxX;
        this.largest = largest;
        // floats round
        gap = 1e-4 + 1e-7 / largest;
        columns = Math.max(1, (int) ((maxX - minX) / largest));
        surface = new int[columns * KEPT];
        kept = new int[columns];
    }

    /** Fills in the centres, in a box from 0 to 1 and as high as it takes. */
    static void pack(float[] radius, float[] x, float[] y) {
        float largest = 0;
        for (float r : radius) {
            largest = Math.max(largest, r);
        }
        double most = largest;
        int strips = radius.length / STRIP + 1;
        IntStream.range(0, strips).parallel().forEach(i -> {
            Packing strip = new Packing(radius, x, y, (double) i / strips, (i + 1.0) / strips, most);
            strip.fill((int) ((long) radius.length * i / strips), (int) ((long) radius.length * (i + 1) / strips));
        });
    }

    private void fill(int from, int to) {
        int circle = floor(from, to);
        // from left to right again and again, each time a little higher
        for (double level = largest; circle < to; level += largest / 2) {
            for (int column = 0; column < columns && circle < to; column++) {
                if (rest(column, radius[circle], level)) {
                    put(circle++, bestX, bestY);
                }
            }
        }
    }

    /** A row on the floor, evenly spaced; returns the first that is not in it. */
    private int floor(int from, int to) {
        double width = 0;
        int end = from;
        while (end < to && width + 2 * radius[end] <= maxX - minX) {
            width += 2 * radius[end++];
        }
        double space = (maxX - minX - width) / (end - from);
        double left = minX;
        for (int i = from; i < end; i++) {
            put(i, left + space / 2 + radius[i], radius[i]);
            left += space + 2 * radius[i];
        }
        return end;
    }

    private int column(double at) {
        return Math.max(0, Math.min(columns - 1, (int) ((at - minX) / (maxX - minX) * columns)));
    }

    private void put(int circle, double atX, double atY) {
        x[circle] = (float) atX;
        y[circle] = (float) atY;
        int column = column(atX);
        int first = column * KEPT;
        System.arraycopy(surface, first, surface, first + 1, KEPT - 1);
        surface[first] = circle;
        kept[column] = Math.min(KEPT, kept[column] + 1);
    }

    /** Whether a circle finds rest in this column, above all others there, about as low as a level; the lowest place is kept. */
    private boolean rest(int column, double r, double level) {
        filling = column;
        top = kept[column] == 0 ? 0 : y[surface[column * KEPT]];
        if (top > level) {
            return false;
        }
        bestY = level + largest;
        nears = 0;
        for (int c = Math.max(0, column - REACH); c <= Math.min(columns - 1, column + REACH); c++) {
            for (int k = c * KEPT; k < c * KEPT + kept[c] && y[surface[k]] > top - 2 * largest; k++) {
                near[nears++] = surface[k];
            }
        }
        boolean found = false;
        for (int i = 0; i < nears; i++) {
            if (column < REACH) {
                found |= onWall(near[i], minX + r * (1 + gap), r);
            }
            if (column >= columns - REACH) {
                found |= onWall(near[i], maxX - r * (1 + gap), r);
            }
            for (int k = i + 1; k < nears; k++) {
                boolean ordered = x[near[i]] < x[near[k]];
                found |= onTwo(near[ordered ? i : k], near[ordered ? k : i], r);
            }
        }
        return found;
    }

    /** Takes the place beside a wall and on a circle if it is lower than the best, and free. */
    private boolean onWall(int on, double atX, double r) {
        double aside = atX - x[on];
        double reach = (r + radius[on]) * (1 + gap);
        return Math.abs(aside) < reach && take(on, on, atX, y[on] + Math.sqrt(reach * reach - aside * aside), r);
    }

    /** Takes the place on two circles if its centre is between theirs, it is lower than the best, and free. */
    private boolean onTwo(int left, int right, double r) {
        double a = (r + radius[left]) * (1 + gap);
        double b = (r + radius[right]) * (1 + gap);
        double dx = (double) x[right] - x[left];
        double dy = (double) y[right] - y[left];
        double d2 = dx * dx + dy * dy;
        if (d2 > (a + b) * (a + b)) {
            return false;
        }
        double along = (a * a - b * b + d2) / (2 * d2);
        double up = Math.sqrt(Math.max(0, a * a / d2 - along * along));
        double atX = x[left] + along * dx - up * dy;
        double atY = y[left] + along * dy + up * dx;
        return atX > x[left] && atX < x[right] && take(left, right, atX, atY, r);
    }

    private boolean take(int one, int other, double atX, double atY, double r) {
        if (atY >= bestY || atY <= top || column(atX) != filling || atX < minX + r || atX > maxX - r) {
            return false;
        }
        for (int i = 0; i < nears; i++) {
            int j = near[i];
            double dx = atX - x[j];
            double dy = atY - y[j];
            double reach = r + radius[j];
            if (j != one && j != other && dx * dx + dy * dy < reach * reach) {
                return false;
            }
        }
        bestX = atX;
        bestY = atY;
        return true;
    }
}
