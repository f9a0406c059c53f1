package io.github.circles2d.host;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Substeps;

/** Twin of {@code kernels/solve.cl}: one pass over the contacts, in the order that match made. */
final class Solve {
    private final SmallState state;
    private final SmallContacts contacts;
    private final Workers workers;
    private final Workers.Work work = this::part;
    private float[] n;
    private int firstOwner;
    private int endOwner;

    Solve(SmallState state, SmallContacts contacts, Workers workers) {
        this.state = state;
        this.contacts = contacts;
        this.workers = workers;
    }

    /** A level and a colour at a time: owners of one colour share no circle. */
    void run() {
        n = state.substeps.numbers();
        Levels levels = state.levels;
        for (int at = 0; at < levels.table.length; at += Levels.INTS) {
            int owners = levels.table[at + Levels.OWNERS];
            for (int colour = 0; colour < Levels.COLOURS; colour++) {
                firstOwner = levels.table[at + Levels.BASE] + colour * owners;
                endOwner = firstOwner + owners;
                int items = contacts.ownerStart[endOwner] - contacts.ownerStart[firstOwner];
                workers.run(items, work);
            }
        }
    }

    private void part(int part, int from, int end) {
        int first = contacts.ownerStart[firstOwner];
        int k = contacts.ownerStart[contacts.ownerFrom(first + from, firstOwner, endOwner)];
        int last = contacts.ownerStart[contacts.ownerFrom(first + end, firstOwner, endOwner)];
        for (; k < last; k++) {
            visit(k);
        }
    }

    /** One visit of a contact: {@link io.github.circles2d.Solver#SMALL_STEPS}. The normal points to the first circle. */
    private void visit(int k) {
        float[] body = state.body;
        int i = contacts.pair[2 * k];
        int j = contacts.pair[2 * k + 1];
        int a = SmallState.BODY * i;
        int b = SmallState.BODY * j;
        float dx = body[a] - body[b];
        float dy = body[a + 1] - body[b + 1];
        float distance = (float) Math.sqrt(dx * dx + dy * dy);
        float nx;
        float ny;
        if (distance > 0) {
            nx = dx / distance;
            ny = dy / distance;
        } else {
            nx = Detect.directionX(contacts.ids[2 * k], contacts.ids[2 * k + 1]);
            ny = Detect.directionY(contacts.ids[2 * k], contacts.ids[2 * k + 1]);
        }
        float ra = body[a + SmallState.RADIUS];
        float rb = body[b + SmallState.RADIUS];
        float wa = body[a + SmallState.INVERSE_MASS];
        float wb = body[b + SmallState.INVERSE_MASS];
        float w = wa + wb;
        float smaller = ra < rb ? ra : rb;
        float larger = ra < rb ? rb : ra;
        float gap = distance - (ra + rb);
        float speed = (body[a + 2] - body[b + 2]) * nx + (body[a + 3] - body[b + 3]) * ny;
        float come = contacts.memory[2 * k];
        float last = contacts.memory[2 * k + 1];
        float impulse = come - (speed + (gap > 0 ? gap : 0) * n[Substeps.PER_TIME]) / w;
        boolean bounced = false;
        if (!(impulse > 0)) {
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
                float bounce = -(speed + n[Substeps.RESTITUTION] * before) / w;
                impulse = bounce > 0 ? bounce : 0;
            }
        }
        float over = -gap - n[Substeps.SLOP] * smaller;
        float push = n[Substeps.PUSH] * (over > 0 ? over : 0);
        float most = n[Substeps.PUSH_MOST] * smaller;
        float share = (push < most ? push : most) / w;
        add(a, wa * share, wa * (impulse - come), nx, ny);
        add(b, -(wb * share), -(wb * (impulse - come)), nx, ny);
        float next = 0;
        if (!bounced && impulse > 0) {
            float beta =
                    larger > n[Substeps.UNEVEN] * smaller ? n[Substeps.EXTRAPOLATE_UNEVEN] : n[Substeps.EXTRAPOLATE];
            beta = -gap > n[Substeps.DEEP] * smaller ? 0 : beta;
            next = extrapolated(impulse, last, beta, n[Substeps.IMPULSE_MOST]);
            body[a + SmallState.KICK_X] += wa * next * nx;
            body[a + SmallState.KICK_Y] += wa * next * ny;
            body[b + SmallState.KICK_X] -= wb * next * nx;
            body[b + SmallState.KICK_Y] -= wb * next * ny;
        }
        contacts.memory[2 * k] = next;
        contacts.memory[2 * k + 1] = bounced ? -1 : impulse;
    }

    private void add(int b, float way, float gain, float nx, float ny) {
        float[] body = state.body;
        body[b] += way * nx;
        body[b + 1] += way * ny;
        body[b + 2] += gain * nx;
        body[b + 3] += gain * ny;
    }

    /** The impulse to come. */
    static float extrapolated(float impulse, float last, float beta, float most) {
        float next = impulse + beta * (impulse - (last > 0 ? last : 0));
        next = next > 0 ? next : 0;
        return next < most ? next : most;
    }

    /** The kernel {@code c2d_rescale}: what an impulse is worth in substeps of another time. */
    void rescale() {
        float ratio = state.number(Substeps.RESCALE);
        for (int k = 0; k < contacts.count; k++) {
            rescale(contacts.memory, 2 * k, 2 * k + 1, ratio);
        }
        for (int i = 0; i < state.circles; i++) {
            for (int wall = 8 * i; wall < 8 * i + 4; wall++) {
                rescale(state.wall, wall, wall + 4, ratio);
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
