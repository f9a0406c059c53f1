package io.github.circles2d.pipeline;

/**
 * How the circles of a world of {@link io.github.circles2d.Solver#SMALL_STEPS} move at the end of a step, as far as the next one is
 * cut by it. The same object each time: a step allocates nothing.
 */
public final class Motion {
    private float fastest;
    private float moved;
    private float speed;

    /**
     * Says how they move from now on.
     *
     * @param newFastest highest speed, radii a second
     * @param newMoved the farthest that one has come in the step, world units
     * @param newSpeed highest speed, world units a second
     */
    public void set(float newFastest, float newMoved, float newSpeed) {
        fastest = newFastest;
        moved = newMoved;
        speed = newSpeed;
    }

    /** Highest speed, radii a second. */
    public float fastest() {
        return fastest;
    }

    /** The farthest that a circle has come in the step, world units; infinite where nobody knows. */
    public float moved() {
        return moved;
    }

    /** Highest speed, world units a second. */
    public float speed() {
        return speed;
    }
}
