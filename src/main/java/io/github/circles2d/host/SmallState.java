package io.github.circles2d.host;

import io.github.circles2d.pipeline.Changes;
import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Motion;
import io.github.circles2d.pipeline.Population;
import io.github.circles2d.pipeline.Substeps;
import java.nio.FloatBuffer;
import java.util.Arrays;

/** The circles of {@link io.github.circles2d.Solver#SMALL_STEPS}: the buffers of {@code kernels/small.cl}, by the same names. */
final class SmallState {
    /** Floats of a {@link #body}, and where in it they are: centre, velocity, kick to come, radius, inverse mass. */
    static final int BODY = 8;

    static final int X = 0;
    static final int Y = 1;
    static final int VX = 2;
    static final int VY = 3;
    static final int KICK_X = 4;
    static final int KICK_Y = 5;
    static final int RADIUS = 6;
    static final int INVERSE_MASS = 7;

    /** What the last impulse of a wall says after a bounce: {@code C2D_BOUNCED}. */
    static final float BOUNCED = 3e38f;

    int circles;
    /** By number, as after the last step. */
    final State published = new State();
    /** By number, for each axis: the impulse to come and the last one, positive from the lower wall, negative from the upper. */
    float[] walls = {};
    /** By place. */
    float[] body = {};

    int[] id = {};
    /** By place: the kick that is in the velocity. */
    float[] kicked = {};
    /** By place: the place at the detection before. */
    int[] from = {};

    /** The circle that comes first in each bucket, and their number. */
    int[] bucketStart = {};

    Levels levels;
    Substeps substeps;
    final Motion motion = new Motion();

    /** The kernel {@code c2d_load}. */
    void upload(Population population, FloatBuffer newVelocities, Levels newLevels) {
        int count = newLevels.circles;
        if (count > id.length || id.length == 0) {
            grow(population.transforms().capacity() / 4);
        }
        published.upload(population, newVelocities);
        float[] circle = published.circle;
        float[] velocities = published.velocities;
        for (int p = 0; p < count; p++) {
            if (p >= circles) {
                id[p] = p;
            }
            int d = id[p];
            int b = BODY * p;
            body[b + X] = circle[4 * d];
            body[b + Y] = circle[4 * d + 1];
            body[b + VX] = velocities[2 * d];
            body[b + VY] = velocities[2 * d + 1];
            body[b + RADIUS] = circle[4 * d + 2];
            body[b + INVERSE_MASS] = 1 / circle[4 * d + 3];
        }
        circles = count;
        levels = newLevels;
    }

    /** The same where velocities alone are others. */
    void velocities(FloatBuffer newVelocities, Changes changed) {
        published.velocities(newVelocities, changed);
        for (int p = 0; p < circles; p++) {
            body[BODY * p + VX] = published.velocities[2 * id[p]];
            body[BODY * p + VY] = published.velocities[2 * id[p] + 1];
        }
    }

    private void grow(int room) {
        walls = Arrays.copyOf(walls, 4 * room);
        body = Arrays.copyOf(body, BODY * room);
        id = Arrays.copyOf(id, room);
        kicked = new float[2 * room];
        from = new int[room];
    }

    /** The finest column of a circle. */
    int column(int i) {
        return levels.column(body[BODY * i + X], number(Substeps.MIN_X));
    }

    /** The finest row of a circle. */
    int row(int i) {
        return levels.row(body[BODY * i + Y], number(Substeps.MIN_X + Substeps.AXIS));
    }

    float number(int which) {
        return substeps.numbers()[which];
    }
}
