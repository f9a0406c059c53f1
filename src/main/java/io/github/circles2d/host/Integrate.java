package io.github.circles2d.host;

import io.github.circles2d.pipeline.Substeps;

/** Twin of {@code kernels/integrate.cl} and {@code walls.cl}: a substep's share of each circle alone. */
final class Integrate {
    private final SmallState state;
    private final Workers workers;
    private final Workers.Work work = this::part;
    private boolean moves;
    private boolean kicks;
    private float[] n;

    Integrate(SmallState state, Workers workers) {
        this.state = state;
        this.workers = workers;
    }

    void run(boolean move, boolean kick) {
        n = state.substeps.numbers();
        moves = move;
        kicks = kick;
        workers.run(state.circles, work);
    }

    private void part(int part, int from, int end) {
        for (int i = from; i < end; i++) {
            if (moves) {
                walls(i);
                move(i);
            }
            if (kicks) {
                kick(i);
            }
        }
    }

    /** The walls, last of the contacts of a pass; gaps are those before any of them moves the circle. */
    private void walls(int i) {
        float[] body = state.body;
        int b = SmallState.BODY * i;
        float x = body[b];
        float y = body[b + 1];
        float radius = body[b + SmallState.RADIUS];
        axis(i, 0, x - n[Substeps.MIN_X] - radius, n[Substeps.MAX_X] - x - radius);
        axis(i, 1, y - n[Substeps.MIN_Y] - radius, n[Substeps.MAX_Y] - y - radius);
    }

    /** Both walls of an axis. */
    private void axis(int i, int axis, float gapLow, float gapHigh) {
        if (!isNear(i, axis, 1, gapLow) && !isNear(i, axis, -1, gapHigh)) {
            return;
        }
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
    private boolean isNear(int i, int axis, float sign, float gap) {
        int b = SmallState.BODY * i;
        float speed = sign * state.body[b + axis + SmallState.VX];
        return gap < 2 * state.body[b + SmallState.RADIUS] || gap + speed * n[Substeps.TIME] < 0;
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
        if (!isNear(i, axis, sign, gap)) {
            return memory(come, last);
        }
        float impulse = come - (speed + (gap > 0 ? gap : 0) * n[Substeps.PER_TIME]) / w;
        boolean bounced = false;
        if (!(impulse > 0)) {
            impulse = 0;
        } else if (come == 0) {
            float ux = state.kicked[2 * i];
            float uy = state.kicked[2 * i + 1];
            float before = speed - sign * (state.kicked[2 * i + axis] + n[Substeps.GAIN_X + axis]);
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

    private void move(int i) {
        float half = 0.5f * state.body[SmallState.BODY * i + SmallState.RADIUS];
        for (int axis = 0; axis < 2; axis++) {
            float[] body = state.body;
            int b = SmallState.BODY * i + axis;
            float min = n[Substeps.MIN_X + axis];
            float max = n[Substeps.MAX_X + axis];
            float position = body[b] + n[Substeps.TIME] * body[b + SmallState.VX];
            float velocity = body[b + SmallState.VX];
            if (!(position >= min + half)) {
                position = min + half;
                velocity = velocity < 0 ? -n[Substeps.RESTITUTION] * velocity : velocity;
            } else if (position > max - half) {
                position = max - half;
                velocity = velocity > 0 ? -n[Substeps.RESTITUTION] * velocity : velocity;
            }
            body[b] = position;
            body[b + SmallState.VX] = velocity;
        }
    }

    private void kick(int i) {
        float[] body = state.body;
        int b = SmallState.BODY * i;
        float kickX = body[b + SmallState.KICK_X];
        float kickY = body[b + SmallState.KICK_Y];
        float slowed = kickX != 0 || kickY != 0 ? n[Substeps.SLOWED] : 1;
        for (int axis = 0; axis < 2; axis++) {
            float kick = body[b + SmallState.KICK_X + axis];
            float velocity = body[b + SmallState.VX + axis] * slowed + (n[Substeps.GAIN_X + axis] + kick);
            float most = n[Substeps.SPEED_X + axis];
            velocity = velocity < most ? velocity : most;
            body[b + SmallState.VX + axis] = velocity > -most ? velocity : -most;
            body[b + SmallState.KICK_X + axis] = 0;
            state.kicked[2 * i + axis] = kick;
        }
    }
}
