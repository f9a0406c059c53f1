// The rule of one contact: Solver.SMALL_STEPS, where it is explained. Twin of host.Solve.visit.

// A contact of circle i, `a`, with circle j, `b`; `memory` is that of the contact. Whether it changed anything. Always part of the
// loop that calls it: PoCL else makes it a call, with all of this through memory.
static inline __attribute__((always_inline)) bool c2d_visit(float8 *circleA, float8 *circleB, float2 *memory, int i, int j,
                                                            __global const int *id, __global const float2 *kicked,
                                                            c2d_numbers n) {
    const float8 a = *circleA;
    const float8 b = *circleB;
    const float dx = a.s0 - b.s0;
    const float dy = a.s1 - b.s1;
    const float distance = sqrt(dx * dx + dy * dy);
    const float perDistance = 1.0f / distance;
    // the normal points to the circle of the list
    const float2 normal = distance > 0.0f ? (float2)(dx * perDistance, dy * perDistance) : c2d_direction(id[i], id[j]);
    const float nx = normal.x;
    const float ny = normal.y;
    const float wa = a.s7;
    const float wb = b.s7;
    const float mass = 1.0f / (wa + wb);
    const float smaller = a.s6 < b.s6 ? a.s6 : b.s6;
    const float larger = a.s6 < b.s6 ? b.s6 : a.s6;
    const float gap = distance - (a.s6 + b.s6);
    const float dvx = a.s2 - b.s2;
    const float dvy = a.s3 - b.s3;
    const float speed = dvx * nx + dvy * ny;
    const float come = (*memory).x;
    const float last = (*memory).y;
    float impulse = come - (speed + c2d_positive(gap) * n.perTime) * mass;
    bool bounced = false;
    if (!(impulse > 0.0f)) {
        if (come == 0.0f && gap >= 0.0f) {
            *memory = (float2)(0.0f, 0.0f);
            return last != 0.0f;
        }
        impulse = 0.0f;
    } else if (come == 0.0f) {
        const float2 ua = kicked[i];
        const float2 ub = kicked[j];
        const float before = speed - ((ua.x - ub.x) * nx + (ua.y - ub.y) * ny);
        const bool carried = ua.x != 0.0f || ua.y != 0.0f || ub.x != 0.0f || ub.y != 0.0f;
        if (before < -n.bounceFrom && !(last < 0.0f && carried)) {
            bounced = true;
            impulse = c2d_positive(-(speed + n.restitution * before) * mass);
        }
    }
    const float push = n.push * c2d_positive(-gap - n.slop * smaller);
    const float most = n.pushMost * smaller;
    const float share = (push < most ? push : most) * mass;
    const float gain = impulse - come;
    const float along = dvy * nx - dvx * ny;
    const bool turns = fabs(along) * n.time > n.turn * distance;
    float next = 0.0f;
    if (!bounced && !turns && impulse > 0.0f) {
        const float shallow = larger > n.uneven * smaller ? n.extrapolateUneven : n.extrapolate;
        const float beta = -gap > n.deep * smaller ? 0.0f : shallow;
        next = c2d_extrapolated(impulse, last, beta, n.impulseMost);
    }
    *circleA = (float8)(a.s0 + wa * share * nx, a.s1 + wa * share * ny, a.s2 + wa * gain * nx, a.s3 + wa * gain * ny,
                        a.s4 + wa * next * nx, a.s5 + wa * next * ny, a.s6, a.s7);
    *circleB = (float8)(b.s0 - wb * share * nx, b.s1 - wb * share * ny, b.s2 - wb * gain * nx, b.s3 - wb * gain * ny,
                        b.s4 - wb * next * nx, b.s5 - wb * next * ny, b.s6, b.s7);
    *memory = (float2)(next, bounced ? -1.0f : impulse);
    return true;
}
