package io.github.circles2d.pipeline;

import java.nio.FloatBuffer;

/**
 * The circles of a world as far as the host knows them.
 *
 * @param circle (x, y, radius, mass) a circle, world units
 * @param circles number of circles
 * @param minRadius smallest radius, world units; 1 without circles
 * @param maxRadius largest radius, world units; 1 without circles
 * @param meanRadius mean radius, world units; 1 without circles
 * @param area sum of their areas, world units squared
 */
public record Population(
        FloatBuffer circle, int circles, float minRadius, float maxRadius, double meanRadius, double area) {

    /** Something done with a radius. */
    interface RadiusAction {
        void accept(float radius);
    }

    /** The circles of a buffer. */
    public static Population of(FloatBuffer circle, int circles) {
        Radii radii = new Radii();
        for (int i = 0; i < circles; i++) {
            radii.add(circle.get(4 * i + 2));
        }
        return radii.population(circle);
    }

    void radii(RadiusAction action) {
        for (int i = 0; i < circles; i++) {
            action.accept(circle.get(4 * i + 2));
        }
    }

    /**
     * Says how circles move whose velocities are not, or not all, those after a step. The arithmetic is that of {@code c2d_publish}.
     *
     * @param before says how far they have come in the last step; null where nobody knows
     */
    void motion(FloatBuffer velocities, Motion before, Motion motion) {
        motion.begin(before);
        for (int i = 0; i < circles; i++) {
            motion.add(velocities.get(2 * i), velocities.get(2 * i + 1), circle.get(4 * i + 2), 0, 0);
        }
    }
}
