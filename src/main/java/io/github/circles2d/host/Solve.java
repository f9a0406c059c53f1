package io.github.circles2d.host;

import io.github.circles2d.pipeline.Substeps;
import io.github.circles2d.pipeline.Workers;

/** Twin of {@code kernels/solve.cl}: one pass over the contacts, in the order that batch made. */
final class Solve {
    private final SmallState state;
    private final SmallContacts contacts;
    private final Workers.Work work = this::part;
    private final Batch batch;
    private float[] n;

    Solve(SmallState state, SmallContacts contacts, Batch batch) {
        this.batch = batch;
        this.state = state;
        this.contacts = contacts;
    }

    void run() {
        n = state.substeps.numbers();
        for (int tiling = 0; tiling < batch.tilings(); tiling++) {
            batch.forTiles(tiling, work);
        }
    }

    private void part(int part, int from, int end) {
        int last = batch.start(end);
        for (int e = batch.start(from); e < last; e++) {
            visit(batch.pairs[2 * e], batch.pairs[2 * e + 1], 2 * e);
        }
    }

    /** One visit of a contact: {@link io.github.circles2d.Solver#SMALL_STEPS}. The normal points to the circle of the list. */
    private void visit(int i, int j, int m) {
        float[] body = state.body;
        float[] memory = contacts.memory;
        int a = SmallState.BODY * i;
        int b = SmallState.BODY * j;
        float dx = body[a] - body[b];
        float dy = body[a + 1] - body[b + 1];
        float distance = (float) Math.sqrt(dx * dx + dy * dy);
        float perDistance = 1 / distance;
        float nx;
        float ny;
        if (distance > 0) {
            nx = dx * perDistance;
            ny = dy * perDistance;
        } else {
            nx = Detect.directionX(state.id[i], state.id[j]);
            ny = Detect.directionY(state.id[i], state.id[j]);
        }
        float ra = body[a + SmallState.RADIUS];
        float rb = body[b + SmallState.RADIUS];
        float wa = body[a + SmallState.INVERSE_MASS];
        float wb = body[b + SmallState.INVERSE_MASS];
        float mass = 1 / (wa + wb);
        float smaller = ra < rb ? ra : rb;
        float larger = ra < rb ? rb : ra;
        float gap = distance - (ra + rb);
        float dvx = body[a + 2] - body[b + 2];
        float dvy = body[a + 3] - body[b + 3];
        float speed = dvx * nx + dvy * ny;
        float come = memory[m];
        float last = memory[m + 1];
        float impulse = come - (speed + (gap > 0 ? gap : 0) * n[Substeps.PER_TIME]) * mass;
        boolean bounced = false;
        if (!(impulse > 0)) {
            if (come == 0 && gap >= 0) {
                // nothing to do, nothing to store
                memory[m + 1] = 0;
                return;
            }
            impulse = 0;
        } else if (come == 0) {
            float uax = state.kicked[2 * i];
            float uay = state.kicked[2 * i + 1];
            float ubx = state.kicked[2 * j];
            float uby = state.kicked[2 * j + 1];
            float before = speed - ((uax - ubx) * nx + (uay - uby) * ny);
            boolean carried = uax != 0 || uay != 0 || ubx != 0 || uby != 0;
            if (before < -n[Substeps.BOUNCE_FROM] && !(last < 0 && carried)) {
                bounced = true;
                float bounce = -(speed + n[Substeps.RESTITUTION] * before) * mass;
                impulse = bounce > 0 ? bounce : 0;
            }
        }
        float over = -gap - n[Substeps.SLOP] * smaller;
        float push = n[Substeps.PUSH] * (over > 0 ? over : 0);
        float most = n[Substeps.PUSH_MOST] * smaller;
        float share = (push < most ? push : most) * mass;
        float gain = impulse - come;
        float along = dvy * nx - dvx * ny;
        boolean turns = Math.abs(along) * n[Substeps.TIME] > n[Substeps.TURN] * distance;
        float next = 0;
        if (!bounced && !turns && impulse > 0) {
            float beta =
                    larger > n[Substeps.UNEVEN] * smaller ? n[Substeps.EXTRAPOLATE_UNEVEN] : n[Substeps.EXTRAPOLATE];
            beta = -gap > n[Substeps.DEEP] * smaller ? 0 : beta;
            next = extrapolated(impulse, last, beta, n[Substeps.IMPULSE_MOST]);
        }
        add(a, wa * share, wa * gain, wa * next, nx, ny);
        add(b, -(wb * share), -(wb * gain), -(wb * next), nx, ny);
        memory[m] = next;
        memory[m + 1] = bounced ? -1 : impulse;
    }

    private void add(int b, float way, float gain, float next, float nx, float ny) {
        float[] body = state.body;
        body[b] += way * nx;
        body[b + 1] += way * ny;
        body[b + 2] += gain * nx;
        body[b + 3] += gain * ny;
        body[b + 4] += next * nx;
        body[b + 5] += next * ny;
    }

    /** The impulse to come. */
    static float extrapolated(float impulse, float last, float beta, float most) {
        float next = impulse + beta * (impulse - (last > 0 ? last : 0));
        next = next > 0 ? next : 0;
        return next < most ? next : most;
    }

    /** The kernel {@code c2d_rescale}: what an impulse is worth in substeps of another time. */
    void rescale(float ratio) {
        for (int k = 0; k < contacts.listStart[state.circles]; k++) {
            rescale(contacts.memory, 2 * k, 2 * k + 1, ratio);
        }
        for (int i = 0; i < state.circles; i++) {
            for (int wall = 4 * i; wall < 4 * i + 4; wall += 2) {
                state.walls[wall] *= ratio;
                float last = state.walls[wall + 1];
                state.walls[wall + 1] = Math.abs(last) < SmallState.BOUNCED ? last * ratio : last;
            }
            state.body[SmallState.BODY * i + SmallState.KICK_X] *= ratio;
            state.body[SmallState.BODY * i + SmallState.KICK_Y] *= ratio;
        }
    }

    private static void rescale(float[] memory, int come, int last, float ratio) {
        memory[come] *= ratio;
        memory[last] = memory[last] > 0 ? memory[last] * ratio : memory[last];
    }
}
