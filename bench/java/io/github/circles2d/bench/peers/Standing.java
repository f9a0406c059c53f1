package io.github.circles2d.bench.peers;

import java.util.Arrays;

/**
 * How well circles stand, from their centres alone, the same for every engine.
 *
 * @param contacts pairs that overlap
 * @param meanOverlap over those, a fraction of the smaller radius or of a given one
 * @param maxOverlap the deepest of them
 * @param energy sum of m v^2 / 2 over the sum of m g r
 * @param height below which 99 % of the centres lie, world units
 * @param outside circles outside the box by more than a radius, or nowhere
 */
public record Standing(
        long contacts, double meanOverlap, double maxOverlap, double energy, double height, int outside) {
    /** Looks at circles in the unit box; overlaps are fractions of the smaller radius. */
    public static Standing of(
            float[] x, float[] y, float[] vx, float[] vy, float[] radius, float[] mass, double gravity) {
        return of(x, y, vx, vy, radius, mass, gravity, 0);
    }

    /** As the other; overlaps are fractions of {@code unit}, world units. */
    public static Standing of(
            float[] x, float[] y, float[] vx, float[] vy, float[] radius, float[] mass, double gravity, double unit) {
        int n = x.length;
        double largest = 0;
        double kinetic = 0;
        double weight = 0;
        int outside = 0;
        for (int i = 0; i < n; i++) {
            largest = Math.max(largest, radius[i]);
            weight += mass[i] * gravity * radius[i];
            boolean inside = x[i] >= -radius[i] && x[i] <= 1 + radius[i] && y[i] >= -radius[i] && y[i] <= 1 + radius[i];
            if (inside) {
                kinetic += mass[i] * ((double) vx[i] * vx[i] + (double) vy[i] * vy[i]) / 2;
            } else {
                outside++;
            }
        }
        float[] heights = y.clone();
        Arrays.sort(heights);
        return new Overlaps(x, y, radius, largest, unit)
                .standing(kinetic / weight, heights[(int) (0.99 * (n - 1))], outside);
    }

    /** Pairs by cells as wide as the largest circle. */
    private static final class Overlaps {
        private final float[] x;
        private final float[] y;
        private final float[] radius;
        private final double unit;
        private final int side;
        private final int[] first;
        private final int[] next;
        private long contacts;
        private double sum;
        private double max;

        Overlaps(float[] x, float[] y, float[] radius, double largest, double unit) {
            this.x = x;
            this.y = y;
            this.radius = radius;
            this.unit = unit;
            side = Math.max(1, (int) (1 / (2 * largest)));
            first = new int[side * side];
            next = new int[x.length];
            Arrays.fill(first, -1);
            for (int i = 0; i < x.length; i++) {
                int cell = cell(y[i]) * side + cell(x[i]);
                next[i] = first[cell];
                first[cell] = i;
            }
        }

        private int cell(float at) {
            return Math.max(0, Math.min(side - 1, (int) (at * side)));
        }

        Standing standing(double energy, double height, int outside) {
            for (int i = 0; i < x.length; i++) {
                int column = cell(x[i]);
                int row = cell(y[i]);
                for (int r = Math.max(0, row - 1); r <= Math.min(side - 1, row + 1); r++) {
                    for (int c = Math.max(0, column - 1); c <= Math.min(side - 1, column + 1); c++) {
                        for (int j = first[r * side + c]; j >= 0; j = next[j]) {
                            if (j > i) {
                                pair(i, j);
                            }
                        }
                    }
                }
            }
            return new Standing(contacts, contacts == 0 ? 0 : sum / contacts, max, energy, height, outside);
        }

        private void pair(int i, int j) {
            double apart = Math.hypot((double) x[i] - x[j], (double) y[i] - y[j]);
            double of = unit > 0 ? unit : Math.min(radius[i], radius[j]);
            double overlap = (radius[i] + (double) radius[j] - apart) / of;
            if (overlap > 0) {
                contacts++;
                sum += overlap;
                max = Math.max(max, overlap);
            }
        }
    }
}
