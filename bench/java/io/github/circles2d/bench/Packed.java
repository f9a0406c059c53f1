package io.github.circles2d.bench;

import io.github.circles2d.demo.Scene;
import java.util.SplittableRandom;

/** The circles of {@link Scene#PILE}, laid out row by row as they lie in a pile, apart from each other and at rest. */
public final class Packed {
    /** Radii and masses as in {@link Scene#PILE}. */
    public static final Scene SCENE = new Scene("packed", 0, -1, 0.5f, (world, circles) -> {
        SplittableRandom random = new SplittableRandom(2014);
        float largest = (float) Math.sqrt(0.35 / (Math.PI * Math.max(1, circles)));
        // a circle takes the mean of the radii to each side: rows are as dense as these circles can lie in rows
        float rise = 2 * largest * 0.9f;
        float x = 0;
        float y = largest;
        for (int i = 0; i < circles; i++) {
            float radius = largest * (0.66f + 0.34f * (float) random.nextDouble());
            if (x + 2 * radius > 1) {
                x = 0;
                y += rise;
            }
            world.addCircle(x + radius, y, radius, 1 + 9 * (float) random.nextDouble());
            x += 2 * radius;
        }
    });

    private Packed() {}
}
