package io.github.circles2d.pipeline;

import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * How the circles of a world of {@link io.github.circles2d.Solver#SMALL_STEPS} move at the end of a step, as far as the next one is
 * cut by it. The same object each time: a step allocates nothing.
 */
public final class Motion {
    /** How many numbers that is, which are those of {@code C2D_MOTION} in {@code kernels/common.cl}. */
    public static final int NUMBERS = 7;

    private static final int FASTEST = 0;
    private static final int MOVED_SQUARE = 1;
    private static final int SPEED_SQUARE = 2;
    private static final int RIGHT = 3;
    private static final int LEFT = 4;
    private static final int UP = 5;
    private static final int DOWN = 6;

    /** The highest of each, none below 0. */
    private final float[] most = new float[NUMBERS];
    /** How far circles may have come since contacts were listed, before the step. */
    private float gone;

    /** Of no circle. */
    public void clear() {
        Arrays.fill(most, 0);
    }

    /** Of no circle yet of a new step, which {@code lists} contacts or goes on with those listed. */
    public void begin(boolean lists) {
        gone = lists ? 0 : come();
        clear();
    }

    /** Of one circle more, which goes so fast, world units a second, and has come so far in the step, world units. */
    public void add(float vx, float vy, float radius, float dx, float dy) {
        float square = vx * vx + vy * vy;
        atLeast(FASTEST, (float) Math.sqrt(square) / radius);
        atLeast(MOVED_SQUARE, dx * dx + dy * dy);
        atLeast(SPEED_SQUARE, square);
        atLeast(RIGHT, vx);
        atLeast(LEFT, -vx);
        atLeast(UP, vy);
        atLeast(DOWN, -vy);
    }

    /** Of those of another besides, as far as they move. */
    public void add(Motion other) {
        for (int k = 0; k < NUMBERS; k++) {
            atLeast(k, other.most[k]);
        }
    }

    private void atLeast(int number, float value) {
        // threads that only read it do not wait for each other
        if (value > most[number]) {
            most[number] = value;
        }
    }

    /** As the status of a device says, from byte {@code at} on. */
    public void set(ByteBuffer status, int at) {
        for (int k = 0; k < NUMBERS; k++) {
            most[k] = status.getFloat(at + 4 * k);
        }
        gone = status.getFloat(at + 4 * NUMBERS);
    }

    /** Nobody knows how far one may have come in the step. */
    void anyFar() {
        most[MOVED_SQUARE] = Float.POSITIVE_INFINITY;
    }

    /** Highest speed, radii a second. */
    public float fastest() {
        return most[FASTEST];
    }

    /** The farthest that a circle has come in the step, world units; infinite where nobody knows. */
    public float moved() {
        return (float) Math.sqrt(most[MOVED_SQUARE]);
    }

    /** The farthest that a circle may have come since contacts were listed, in all steps since then, world units; of the stages alone. */
    public float come() {
        return gone + moved();
    }

    /** Highest speed, world units a second. */
    public float speed() {
        return (float) Math.sqrt(most[SPEED_SQUARE]);
    }

    /** No two circles close in on each other faster at the end of the step, world units a second: the diagonal of the box of all velocities and 0. */
    public float closing() {
        float width = most[RIGHT] + most[LEFT];
        float height = most[UP] + most[DOWN];
        return (float) Math.sqrt(width * width + height * height);
    }
}
