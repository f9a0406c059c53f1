package io.github.circles2d;

/** Where detect leaves what it finds. Never changes the result. */
public enum CollisionStore {
    /** A list of the contacts alone. The default. */
    COMPACT,

    /**
     * The thesis' buffer {@code collision}: one translation vector for every pair of circles, zero for those apart;
     * 8 n(n-1)/2 bytes, in slices where that is more than one allocation. Resolve walks it again, pair by pair. For
     * the reproduction of the thesis, so under {@link Solver#IMPULSE} and with a strategy that has pairs alone; elsewhere
     * it is {@link #COMPACT}. 0.9 GB at 15,000 circles.
     */
    TRIANGLE
}
