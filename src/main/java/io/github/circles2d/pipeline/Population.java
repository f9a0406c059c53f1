package io.github.circles2d.pipeline;

import java.nio.FloatBuffer;

/**
 * The circles of a world as far as the host knows them.
 *
 * @param transforms (x, y, radius, angle) a circle, world units; direct, native order, read from 0
 * @param masses mass of each, in any unit; direct, native order, read from 0
 * @param circles number of circles
 * @param minRadius smallest radius, world units; 1 without circles
 * @param maxRadius largest radius, world units; 1 without circles
 * @param meanRadius mean radius, world units; 1 without circles
 * @param area sum of their areas, world units squared
 */
public record Population(
        FloatBuffer transforms,
        FloatBuffer masses,
        int circles,
        float minRadius,
        float maxRadius,
        double meanRadius,
        double area) {

    /** Something done with a radius. */
    interface RadiusAction {
        void accept(float radius);
    }

    /** The circles of buffers, as the record has them. */
    public static Population of(FloatBuffer transforms, FloatBuffer masses, int circles) {
        Radii radii = new Radii();
        for (int i = 0; i < circles; i++) {
            radii.add(transforms.get(4 * i + 2));
        }
        return radii.population(transforms, masses);
    }

    void radii(RadiusAction action) {
        for (int i = 0; i < circles; i++) {
            action.accept(transforms.get(4 * i + 2));
        }
    }

    /** Says how circles {@code from .. end - 1} move, whose velocities are not those after a step. The arithmetic is that of {@code c2d_publish}. */
    void motion(FloatBuffer velocities, int from, int end, Motion motion) {
        for (int i = from; i < end; i++) {
            motion.add(velocities.get(2 * i), velocities.get(2 * i + 1), transforms.get(4 * i + 2), 0, 0);
        }
    }
}
