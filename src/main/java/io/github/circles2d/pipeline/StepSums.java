package io.github.circles2d.pipeline;

import java.nio.ByteBuffer;

/**
 * Adds up what a step looks like from the parts of {@code kernels/stats.cl}, in their order: the same on every device. Not
 * thread-safe.
 */
public final class StepSums {
    /** Circles, contacts or lists of one part: {@code C2D_PART}. */
    public static final int PART = 64;

    /** Bytes of a part of circles, a float8, and of contacts, an uint4. */
    public static final int CIRCLES_BYTES = 32;

    public static final int CONTACTS_BYTES = 16;

    /** Overlaps are counted in smaller radii times this. */
    private static final double OVERLAP_UNIT = 1.0 / (1 << 24);

    private double energy;
    private double momentumX;
    private double momentumY;
    private double fastest;
    private long outside;
    private long overlap;
    private long touching;
    private double largest;

    /** Parts of so many. */
    public static int parts(int count) {
        return (int) (((long) count + PART - 1) / PART);
    }

    /** Adds parts of circles, read from 0: energy, momentum along x and y, each with what rounding took; speed; outside. */
    public void addCircles(ByteBuffer parts, int count) {
        for (int at = 0; at < CIRCLES_BYTES * count; at += CIRCLES_BYTES) {
            energy += sum(parts, at);
            momentumX += sum(parts, at + 8);
            momentumY += sum(parts, at + 16);
            fastest = Math.max(fastest, parts.getFloat(at + 24));
            outside += (long) parts.getFloat(at + 28);
        }
    }

    /** Where a sum overflows, what rounding took is not a number. */
    private static double sum(ByteBuffer parts, int at) {
        double lost = parts.getFloat(at + 4);
        return Double.isNaN(lost) ? parts.getFloat(at) : parts.getFloat(at) + lost;
    }

    /** Adds parts of contacts, read from 0: sum of overlaps, low and high word; how many touch; largest overlap. */
    public void addContacts(ByteBuffer parts, int count) {
        for (int at = 0; at < CONTACTS_BYTES * count; at += CONTACTS_BYTES) {
            overlap += Integer.toUnsignedLong(parts.getInt(at)) + ((long) parts.getInt(at + 4) << 32);
            touching += Integer.toUnsignedLong(parts.getInt(at + 8));
            largest = Math.max(largest, parts.getFloat(at + 12));
        }
    }

    public double energy() {
        return energy;
    }

    public double momentumX() {
        return momentumX;
    }

    public double momentumY() {
        return momentumY;
    }

    public double fastest() {
        return fastest;
    }

    public long outside() {
        return outside;
    }

    /** Contacts that overlap. */
    public long touching() {
        return touching;
    }

    public double largestOverlap() {
        return largest;
    }

    public double meanOverlap() {
        return touching == 0 ? 0 : overlap * OVERLAP_UNIT / touching;
    }
}
