package io.github.circles2d.host;

import io.github.circles2d.pipeline.Motion;
import io.github.circles2d.pipeline.Substeps;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.Workers;
import java.util.Arrays;

/** Twin of {@code kernels/integrate.cl} and {@code walls.cl}: a substep's share of each circle alone. */
final class Integrate {
    private final SmallState state;
    private final Workers workers;
    private final Workers.Work work = this::part;
    private boolean moves;
    private boolean kicks;
    private boolean publishes;
    /** Of each part. */
    private final Motion[] motions;

    private float[] n;

    Integrate(SmallState state, Workers workers) {
        this.state = state;
        this.workers = workers;
        motions = new Motion[workers.most()];
        Arrays.setAll(motions, part -> new Motion());
    }

    /** The end of a substep, the start of one, and, where that was the last of a step, what others see of the circles. */
    void run(boolean move, boolean kick, boolean publish) {
        n = state.substeps.numbers();
        moves = move;
        kicks = kick;
        publishes = publish;
        workers.run(state.circles, work);
        if (publish) {
            for (Motion motion : motions) {
                state.motion.add(motion);
                motion.clear();
            }
        }
    }

    private void part(int part, int from, int end) {
        for (int first = from; first < end; first += Tuning.HOST_TURN) {
            int last = Math.min(first + Tuning.HOST_TURN, end);
            if (moves) {
                move(first, last, 0);
                move(first, last, 1);
            }
            if (kicks) {
                kick(first, last);
            }
            if (publishes) {
                publish(first, last, motions[part]);
            }
        }
    }

    /** {@code c2d_both_walls}, last of the contacts of a pass, then {@code c2d_small_move}. */
    private void move(int from, int end, int axis) {
        float[] body = state.body;
        float time = n[Substeps.TIME];
        float least = n[Substeps.MIN_X + Substeps.AXIS * axis];
        float most = n[Substeps.MAX_X + Substeps.AXIS * axis];
        for (int i = from; i < end; i++) {
            int b = SmallState.BODY * i + axis;
            float radius = body[SmallState.BODY * i + SmallState.RADIUS];
            float position = body[b];
            float velocity = body[b + SmallState.VX];
            // gaps are those before either wall moves the circle
            float gapLow = position - least - radius;
            float gapHigh = most - position - radius;
            if (isNear(velocity, gapLow, radius, time) || isNear(-velocity, gapHigh, radius, time)) {
                walls(i, axis, gapLow, gapHigh);
                position = body[b];
                velocity = body[b + SmallState.VX];
            }
            position += time * velocity;
            float half = 0.5f * radius;
            if (!(position >= least + half)) {
                position = least + half;
                velocity = velocity < 0 ? -n[Substeps.RESTITUTION] * velocity : velocity;
            } else if (position > most - half) {
                position = most - half;
                velocity = velocity > 0 ? -n[Substeps.RESTITUTION] * velocity : velocity;
            }
            body[b] = position;
            body[b + SmallState.VX] = velocity;
        }
    }

    private void walls(int i, int axis, float gapLow, float gapHigh) {
        float[] walls = state.walls;
        int at = 4 * state.id[i] + 2 * axis;
        float come = walls[at];
        float last = walls[at + 1];
        long low = wall(i, axis, 1, gapLow, positive(come), recalled(last));
        long high = wall(i, axis, -1, gapHigh, positive(-come), recalled(-last));
        walls[at] = come(low) != 0 ? come(low) : -come(high);
        walls[at + 1] = kept(low) != 0 ? kept(low) : -kept(high);
    }

    /** {@code c2d_near_wall}. */
    private static boolean isNear(float speed, float gap, float radius, float time) {
        return gap < 2 * radius || gap + speed * time < 0;
    }

    private static float positive(float x) {
        return x > 0 ? x : 0;
    }

    /** {@code c2d_of_wall}. */
    private static float recalled(float last) {
        return last >= SmallState.BOUNCED ? -1 : positive(last);
    }

    /** Two floats in one. */
    private static long memory(float come, float last) {
        return (long) Float.floatToRawIntBits(come) << 32 | Float.floatToRawIntBits(last) & 0xFFFFFFFFL;
    }

    private static float come(long memory) {
        return Float.intBitsToFloat((int) (memory >> 32));
    }

    private static float kept(long memory) {
        float last = Float.intBitsToFloat((int) memory);
        return last < 0 ? SmallState.BOUNCED : last;
    }

    /** As {@link Solve#visit}, against something that does not move. */
    private long wall(int i, int axis, float sign, float gap, float come, float last) {
        float[] body = state.body;
        int b = SmallState.BODY * i + axis;
        float radius = body[SmallState.BODY * i + SmallState.RADIUS];
        float w = body[SmallState.BODY * i + SmallState.INVERSE_MASS];
        float speed = sign * body[b + SmallState.VX];
        if (!isNear(speed, gap, radius, n[Substeps.TIME])) {
            return memory(come, last);
        }
        float impulse = come - (speed + (gap > 0 ? gap : 0) * n[Substeps.PER_TIME]) / w;
        boolean bounced = false;
        if (!(impulse > 0)) {
            impulse = 0;
        } else if (come == 0) {
            float ux = state.kicked[2 * i];
            float uy = state.kicked[2 * i + 1];
            float before = speed - sign * (state.kicked[2 * i + axis] + n[Substeps.GAIN_X + Substeps.AXIS * axis]);
            if (before < -n[Substeps.BOUNCE_FROM] && !(last < 0 && (ux != 0 || uy != 0))) {
                bounced = true;
                float bounce = -(speed + n[Substeps.RESTITUTION] * before) / w;
                impulse = bounce > 0 ? bounce : 0;
            }
        }
        float over = -gap - n[Substeps.SLOP] * radius;
        float push = n[Substeps.PUSH] * (over > 0 ? over : 0);
        float most = n[Substeps.PUSH_MOST] * radius;
        body[b] += sign * (push < most ? push : most);
        body[b + SmallState.VX] += sign * (w * (impulse - come));
        float next = 0;
        if (!bounced && impulse > 0) {
            next = Solve.extrapolated(impulse, last, n[Substeps.EXTRAPOLATE], n[Substeps.IMPULSE_MOST]);
            body[b + SmallState.KICK_X] += sign * (w * next);
        }
        return memory(next, bounced ? -1 : impulse);
    }

    private void kick(int from, int end) {
        float[] body = state.body;
        float[] kicked = state.kicked;
        float gainX = n[Substeps.GAIN_X];
        float gainY = n[Substeps.GAIN_X + Substeps.AXIS];
        float mostX = n[Substeps.SPEED_X];
        float mostY = n[Substeps.SPEED_X + Substeps.AXIS];
        float slower = n[Substeps.SLOWED];
        for (int i = from; i < end; i++) {
            int b = SmallState.BODY * i;
            float kickX = body[b + SmallState.KICK_X];
            float kickY = body[b + SmallState.KICK_Y];
            float slowed = kickX != 0 || kickY != 0 ? slower : 1;
            body[b + SmallState.VX] = kicked(body[b + SmallState.VX], slowed, gainX + kickX, mostX);
            body[b + SmallState.VY] = kicked(body[b + SmallState.VY], slowed, gainY + kickY, mostY);
            body[b + SmallState.KICK_X] = 0;
            body[b + SmallState.KICK_Y] = 0;
            kicked[2 * i] = kickX;
            kicked[2 * i + 1] = kickY;
        }
    }

    /** {@code c2d_publish}. */
    private void publish(int from, int end, Motion motion) {
        float[] body = state.body;
        float[] circle = state.published.circle;
        float[] velocities = state.published.velocities;
        for (int i = from; i < end; i++) {
            int b = SmallState.BODY * i;
            int d = state.id[i];
            float x = body[b + SmallState.X];
            float y = body[b + SmallState.Y];
            float vx = body[b + SmallState.VX];
            float vy = body[b + SmallState.VY];
            motion.add(vx, vy, body[b + SmallState.RADIUS], x - circle[4 * d], y - circle[4 * d + 1]);
            circle[4 * d] = x;
            circle[4 * d + 1] = y;
            velocities[2 * d] = vx;
            velocities[2 * d + 1] = vy;
        }
    }

    private static float kicked(float before, float slowed, float gain, float most) {
        float velocity = before * slowed + gain;
        float low = velocity < most ? velocity : most;
        return low > -most ? low : -most;
    }
}
