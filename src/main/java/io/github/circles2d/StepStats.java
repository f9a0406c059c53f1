package io.github.circles2d;

/**
 * What the last finished step looked like.
 *
 * <p>Contacts are those of circles that overlap: under {@link Solver#IMPULSE} as the step found them, before it resolved
 * them; under {@link Solver#SMALL_STEPS} after the step. All of it is computed on the device, in 32-bit floats with
 * compensated sums and in whole numbers, so that every device gives the same bits.
 *
 * @param steps steps since the world was built
 * @param contacts contacts of that step
 * @param maxOverlap deepest overlap of them, a fraction of the smaller radius of its two circles; 0 without contacts
 * @param meanOverlap mean of the same over all contacts; 0 without contacts
 * @param kineticEnergy sum of m v^2 / 2 after the step, mass x (world units / s)^2
 * @param momentumX sum of m vx after the step, mass x world units / s
 * @param momentumY sum of m vy after the step
 * @param maxSpeed highest speed after the step, world units / s
 * @param outside circles that reach over a wall after the step, under {@link Solver#SMALL_STEPS} by more than half of their
 *     radius; 0 unless the library is broken
 */
public record StepStats(
        long steps,
        long contacts,
        double maxOverlap,
        double meanOverlap,
        double kineticEnergy,
        double momentumX,
        double momentumY,
        double maxSpeed,
        int outside) {}
