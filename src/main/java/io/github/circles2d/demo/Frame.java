package io.github.circles2d.demo;

import io.github.circles2d.Snapshot;

/**
 * A copy of the circles, for another thread to paint. Not changed once made.
 *
 * @param circles (x, y, radius, mass) a circle, in the unit square, y up
 */
record Frame(float[] circles) {
    static final Frame EMPTY = new Frame(new float[0]);

    static Frame of(Snapshot now) {
        float[] circles = new float[4 * now.count()];
        for (int slot = 0; slot < now.count(); slot++) {
            circles[4 * slot] = now.x(slot);
            circles[4 * slot + 1] = now.y(slot);
            circles[4 * slot + 2] = now.radius(slot);
            circles[4 * slot + 3] = now.mass(slot);
        }
        return new Frame(circles);
    }
}
