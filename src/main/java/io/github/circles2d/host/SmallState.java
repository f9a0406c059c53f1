package io.github.circles2d.host;

import io.github.circles2d.pipeline.Levels;
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

    /** Numbers of a {@link #cell}: finest column and row, level. */
    static final int CELL = 3;

    int circles;
    /** By number: (x, y, radius, mass), and (vx, vy), as after the last step. */
    float[] circle = {};

    float[] velocities = {};
    /** By number: the kick to come after the last step. */
    float[] kick = {};
    /** By number: of the left, right, lower and upper wall the impulse to come, then the last one of each; -1 after a bounce. */
    float[] wall = {};
    /** By number: the cell at this detection and at the one before; level -1 for a circle that was not there. */
    int[] cell = {};

    int[] cellBefore = {};
    /** By number. */
    int[] level = {};

    /** In the order of the cells. */
    float[] body = {};

    int[] id = {};
    /** In the order of the cells: the kick that is in the velocity. */
    float[] kicked = {};

    /** The circle that comes first in each bucket, and their number. */
    int[] bucketStart = {};

    Levels levels;
    Levels levelsBefore;
    Substeps substeps;
    float fastest;

    /** The kernel {@code c2d_load}. */
    void upload(FloatBuffer newCircle, FloatBuffer newVelocities, Levels newLevels) {
        int count = newLevels.circles;
        if (count > id.length || id.length == 0) {
            grow(newCircle.capacity() / 4);
        }
        circles = count;
        levels = newLevels;
        newCircle.get(0, circle, 0, 4 * count);
        newVelocities.get(0, velocities, 0, 2 * count);
        for (int i = 0; i < count; i++) {
            int b = BODY * i;
            id[i] = i;
            level[i] = newLevels.levelOf(circle[4 * i + 2]);
            body[b + X] = circle[4 * i];
            body[b + Y] = circle[4 * i + 1];
            body[b + VX] = velocities[2 * i];
            body[b + VY] = velocities[2 * i + 1];
            body[b + KICK_X] = kick[2 * i];
            body[b + KICK_Y] = kick[2 * i + 1];
            body[b + RADIUS] = circle[4 * i + 2];
            body[b + INVERSE_MASS] = 1 / circle[4 * i + 3];
        }
    }

    private void grow(int room) {
        circle = new float[4 * room];
        velocities = new float[2 * room];
        kick = Arrays.copyOf(kick, 2 * room);
        wall = Arrays.copyOf(wall, 8 * room);
        cell = grown(cell, room);
        cellBefore = grown(cellBefore, room);
        level = new int[room];
        body = new float[BODY * room];
        id = new int[room];
        kicked = new float[2 * room];
    }

    private static int[] grown(int[] old, int room) {
        int[] grown = Arrays.copyOf(old, CELL * room);
        Arrays.fill(grown, old.length, grown.length, -1);
        return grown;
    }

    /** The kernel {@code c2d_publish}. */
    void publish() {
        fastest = 0;
        for (int i = 0; i < circles; i++) {
            int b = BODY * i;
            int d = id[i];
            float vx = body[b + VX];
            float vy = body[b + VY];
            circle[4 * d] = body[b + X];
            circle[4 * d + 1] = body[b + Y];
            velocities[2 * d] = vx;
            velocities[2 * d + 1] = vy;
            kick[2 * d] = body[b + KICK_X];
            kick[2 * d + 1] = body[b + KICK_Y];
            float speed = (float) Math.sqrt(vx * vx + vy * vy) / body[b + RADIUS];
            fastest = speed > fastest ? speed : fastest;
        }
    }

    void download(FloatBuffer toCircle, FloatBuffer toVelocities) {
        toCircle.put(0, circle, 0, 4 * circles);
        toVelocities.put(0, velocities, 0, 2 * circles);
    }

    float number(int which) {
        return substeps.numbers()[which];
    }
}
