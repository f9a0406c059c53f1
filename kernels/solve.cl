// One pass over the contacts: Solver.SMALL_STEPS. Twin of host.Solve.

// The numbers that a visit needs: read once, for the compiler cannot know that circles are not stored over them.
typedef struct {
    float time;
    float perTime;
    float bounceFrom;
    float restitution;
    float push;
    float pushMost;
    float slop;
    float deep;
    float extrapolate;
    float extrapolateUneven;
    float uneven;
    float impulseMost;
    float turn;
} c2d_numbers;

static c2d_numbers c2d_numbers_of(__global const float *rule) {
    const c2d_numbers n = {C2D_TIME, C2D_PER_TIME,    C2D_BOUNCE_FROM,        C2D_RESTITUTION, C2D_PUSH,
                           C2D_PUSH_MOST, C2D_SLOP,    C2D_DEEP,               C2D_EXTRAPOLATE, C2D_EXTRAPOLATE_UNEVEN,
                           C2D_UNEVEN,    C2D_IMPULSE_MOST, C2D_TURN};
    return n;
}

// Contact k of circle i, `a`, with circle j, `b`; `memory` is that of the contact. Whether it changed anything.
static bool c2d_visit(float8 *circleA, float8 *circleB, float2 *memory, int i, int j, __global const int *id,
                      __global const float2 *kicked, c2d_numbers n) {
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

#define C2D_SOLVE                                                                                                      \
    __global float8 *body, __global const int *id, __global const float2 *kicked, __global const int *listStart,         \
        __global const int *other, __global float2 *memory, __global const int *bucketStart,                             \
        __global const uint *status, __global const int8 *levels, __global const float *rule
#define C2D_SOLVE_HERE body, id, kicked, listStart, other, memory, bucketStart, status, levels, rule

// The lists of the circles of one bucket, one after the other. Memory is slow and the contacts wait for each other, so that
// each is read before the one ahead of it is done; what that one changes of its circles is passed on.
static void c2d_solve_bucket(int bucket, c2d_numbers numbers, C2D_SOLVE) {
    int i = bucketStart[bucket];
    const int last = bucketStart[bucket + 1];
    int k = listStart[i];
    const int end = listStart[last];
    if (k >= end) {
        return;
    }
    int listEnd = listStart[i + 1];
    while (listEnd == k) {
        i++;
        listEnd = listStart[i + 1];
    }
    int nextEnd = listStart[min(i + 2, last)];
    int j = other[k];
    float2 remembered = memory[k];
    float8 a = body[i];
    float8 b = body[j];
    int nextJ = other[min(k + 1, end - 1)];
    for (;;) {
        const int next = k + 1;
        int nextI = i;
        if (next == listEnd && next < end) {
            do {
                nextI++;
                listEnd = nextEnd;
                nextEnd = listStart[min(nextI + 2, last)];
            } while (listEnd == next);
        }
        const int afterJ = other[min(next + 1, end - 1)];
        float2 nextRemembered = memory[min(next, end - 1)];
        float8 nextA = body[nextI];
        float8 nextB = body[nextJ];
        if (c2d_visit(&a, &b, &remembered, i, j, id, kicked, numbers)) {
            body[j] = b;
            memory[k] = remembered;
        }
        if (nextI != i || next == end) {
            body[i] = a;
        }
        if (next == end) {
            return;
        }
        nextA = nextI == i ? a : nextI == j ? b : nextA;
        nextB = nextJ == j ? b : nextJ == i ? a : nextB;
        i = nextI;
        j = nextJ;
        k = next;
        a = nextA;
        b = nextB;
        remembered = nextRemembered;
        nextJ = afterJ;
    }
}

// The buckets of one colour of one level, of those `rows` rows apart whose column and row leave `x` and `y`: one work-item
// each. `across`: how many there are in a row.
__kernel void c2d_solve(C2D_SOLVE, int number, int x, int y, int rows, int across, int buckets) {
    const int item = (int)get_global_id(0);
    if (item >= buckets || status[C2D_STALLED] != 0u) {
        return;
    }
    const int8 level = levels[1 + number];
    const int row = y + rows * (item / across);
    c2d_solve_bucket(level.C2D_BASE + row * level.C2D_WIDTH + x + 3 * (item % across), c2d_numbers_of(rule),
                     C2D_SOLVE_HERE);
}

// The levels from `firstLevel` on, all of their colours, in one launch of one work-group: where buckets are few, launches
// would cost more than the work.
__kernel void c2d_solve_narrow(C2D_SOLVE, int firstLevel, int levelCount) {
    const bool stalled = status[C2D_STALLED] != 0u;
    const c2d_numbers numbers = c2d_numbers_of(rule);
    for (int number = firstLevel; number < levelCount; number++) {
        const int8 level = levels[1 + number];
        const int rows = number == 0 ? 2 : 3;
        for (int colour = 0; colour < 3 * rows; colour++) {
            const int x = colour % 3;
            const int y = colour / 3;
            const int across = (level.C2D_WIDTH - x + 2) / 3;
            const int buckets = stalled ? 0 : across * ((level.C2D_HEIGHT - y + rows - 1) / rows);
            for (int item = (int)get_local_id(0); item < buckets; item += (int)get_local_size(0)) {
                const int row = y + rows * (item / across);
                c2d_solve_bucket(level.C2D_BASE + row * level.C2D_WIDTH + x + 3 * (item % across), numbers, C2D_SOLVE_HERE);
            }
            barrier(CLK_GLOBAL_MEM_FENCE);
        }
    }
}

static float2 c2d_rescaled(float come, float last, float ratio) {
    return (float2)(come * ratio, last > 0.0f ? last * ratio : last);
}

// What impulses are worth in substeps of another time. One work-item a circle, going round where contacts are more.
__kernel void c2d_rescale(__global float8 *body, __global float2 *walls, __global float2 *memory,
                          __global const int *listStart, int circles, __global const float *rule) {
    const float ratio = C2D_RESCALE;
    const int i = (int)get_global_id(0);
    const int contacts = listStart[circles];
    for (int k = i; k < contacts; k += (int)get_global_size(0)) {
        memory[k] = c2d_rescaled(memory[k].x, memory[k].y, ratio);
    }
    if (i < circles) {
        for (int axis = 2 * i; axis < 2 * i + 2; axis++) {
            const float2 wall = walls[axis];
            walls[axis] = (float2)(wall.x * ratio, fabs(wall.y) < C2D_BOUNCED ? wall.y * ratio : wall.y);
        }
        body[i].s4 *= ratio;
        body[i].s5 *= ratio;
    }
}
