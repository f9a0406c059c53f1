package io.github.circles2d.bench;

import io.github.circles2d.Circles2D;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.Snapshot;
import io.github.circles2d.demo.Scene;
import java.util.SplittableRandom;

/**
 * The circles of the scene {@code pile} at rest, as numbers, so that other engines and other places can have the same.
 *
 * @param x centres, world units, in the unit square
 * @param radius world units
 */
public record Layout(float[] x, float[] y, float[] radius, float[] mass) {
    /** Whose rules and circles these are. */
    public static final Scene SCENE = Scene.PILE;

    /** As the scene has them: all over the box, about to fall. */
    static Layout start(int circles) {
        // plain Java: nothing is stepped, so nothing need reach a device
        try (Circles2D world = SCENE.build(Circles2D.builder().device(ComputeDevice.host()), circles)) {
            Snapshot now = world.snapshot();
            Layout layout = empty(circles);
            for (int i = 0; i < circles; i++) {
                layout.x[i] = now.x(i);
                layout.y[i] = now.y(i);
                layout.radius[i] = now.radius(i);
                layout.mass[i] = now.mass(i);
            }
            return layout;
        }
    }

    private static Layout empty(int circles) {
        return new Layout(new float[circles], new float[circles], new float[circles], new float[circles]);
    }

    /**
     * Circles of the same sizes, row by row, apart from each other and at rest: about as dense as a pile, but not yet one, and with
     * little more than half of its contacts.
     */
    public static Layout rows(int circles) {
        Layout layout = empty(circles);
        SplittableRandom random = new SplittableRandom(2014);
        float largest = (float) Math.sqrt(0.35 / (Math.PI * Math.max(1, circles)));
        // a circle takes the mean of the radii to each side: rows are as dense as these circles can lie in rows
        float rise = 2 * largest * 0.9f;
        float left = 0;
        float up = largest;
        for (int i = 0; i < circles; i++) {
            float radius = largest * (0.66f + 0.34f * (float) random.nextDouble());
            if (left + 2 * radius > 1) {
                left = 0;
                up += rise;
            }
            layout.x[i] = left + radius;
            layout.y[i] = up;
            layout.radius[i] = radius;
            layout.mass[i] = 1 + 9 * (float) random.nextDouble();
            left += 2 * radius;
        }
        return layout;
    }

    /**
     * The same circles laid on the floor and on each other, as {@link Packing} does: a pile that nothing has to fall for. Nobody has
     * balanced its forces: it gives way a little in the first steps.
     */
    static Layout packed(int circles) {
        Layout layout = start(circles);
        Packing.pack(layout.radius, layout.x, layout.y);
        return layout;
    }

    int count() {
        return x.length;
    }

    /** Mean radius, world units. */
    double meanRadius() {
        double sum = 0;
        for (float r : radius) {
            sum += r;
        }
        return sum / count();
    }

    /** (x, y, radius, mass) of each. */
    float[] circles() {
        float[] circles = new float[4 * count()];
        for (int i = 0; i < count(); i++) {
            circles[4 * i] = x[i];
            circles[4 * i + 1] = y[i];
            circles[4 * i + 2] = radius[i];
            circles[4 * i + 3] = mass[i];
        }
        return circles;
    }

    /** A world with these circles and the rules of the scene. */
    public Circles2D world(Circles2D.Builder builder) {
        Circles2D world = SCENE.empty(builder, count());
        try {
            world.addCircles(circles());
            return world;
        } catch (RuntimeException e) {
            world.close();
            throw e;
        }
    }
}
