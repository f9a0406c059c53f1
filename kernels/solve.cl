// One pass over the contacts: Solver.SMALL_STEPS. Twin of host.Solve.

// Circle i and the contact k with a circle j; what it changes of i stays in the hands of the caller.
static float8 c2d_visit(float8 a, int i, int k, __global float8 *body, __global const int *id,
                        __global const float2 *kicked, __global const int *other, __global float2 *memory,
                        __global const float *rule) {
    const int j = other[k];
    float8 b = body[j];
    const float dx = a.s0 - b.s0;
    const float dy = a.s1 - b.s1;
    const float distance = sqrt(dx * dx + dy * dy);
    // the normal points to the circle of the list
    const float2 normal = distance > 0.0f ? (float2)(dx / distance, dy / distance) : c2d_direction(id[i], id[j]);
    const float nx = normal.x;
    const float ny = normal.y;
    const float wa = a.s7;
    const float wb = b.s7;
    const float w = wa + wb;
    const float smaller = a.s6 < b.s6 ? a.s6 : b.s6;
    const float larger = a.s6 < b.s6 ? b.s6 : a.s6;
    const float gap = distance - (a.s6 + b.s6);
    const float speed = (a.s2 - b.s2) * nx + (a.s3 - b.s3) * ny;
    const float come = memory[k].x;
    const float last = memory[k].y;
    float impulse = come - (speed + c2d_positive(gap) * C2D_PER_TIME) / w;
    bool bounced = false;
    if (!(impulse > 0.0f)) {
        if (come == 0.0f && gap >= 0.0f) {
            // nothing to do, nothing to store
            if (last != 0.0f) {
                memory[k] = (float2)(0.0f, 0.0f);
            }
            return a;
        }
        impulse = 0.0f;
    } else if (come == 0.0f) {
        const float2 ua = kicked[i];
        const float2 ub = kicked[j];
        const float before = speed - ((ua.x - ub.x) * nx + (ua.y - ub.y) * ny);
        const bool carried = ua.x != 0.0f || ua.y != 0.0f || ub.x != 0.0f || ub.y != 0.0f;
        if (before < -C2D_BOUNCE_FROM && !(last < 0.0f && carried)) {
            bounced = true;
            impulse = c2d_positive(-(speed + C2D_RESTITUTION * before) / w);
        }
    }
    const float push = C2D_PUSH * c2d_positive(-gap - C2D_SLOP * smaller);
    const float most = C2D_PUSH_MOST * smaller;
    const float share = (push < most ? push : most) / w;
    const float wayA = wa * share;
    const float wayB = wb * share;
    const float gainA = wa * (impulse - come);
    const float gainB = wb * (impulse - come);
    a.s0 += wayA * nx;
    a.s1 += wayA * ny;
    a.s2 += gainA * nx;
    a.s3 += gainA * ny;
    b.s0 -= wayB * nx;
    b.s1 -= wayB * ny;
    b.s2 -= gainB * nx;
    b.s3 -= gainB * ny;
    float next = 0.0f;
    if (!bounced && impulse > 0.0f) {
        const float shallow = larger > C2D_UNEVEN * smaller ? C2D_EXTRAPOLATE_UNEVEN : C2D_EXTRAPOLATE;
        const float beta = -gap > C2D_DEEP * smaller ? 0.0f : shallow;
        next = c2d_extrapolated(impulse, last, beta, C2D_IMPULSE_MOST);
        a.s4 += wa * next * nx;
        a.s5 += wa * next * ny;
        b.s4 -= wb * next * nx;
        b.s5 -= wb * next * ny;
    }
    body[j] = b;
    memory[k] = (float2)(next, bounced ? -1.0f : impulse);
    return a;
}

#define C2D_SOLVE                                                                                                      \
    __global float8 *body, __global const int *id, __global const float2 *kicked, __global const int *listStart,         \
        __global const int *other, __global float2 *memory, __global const int *bucketStart,                             \
        __global const uint *status, __global const int8 *levels, __global const float *rule
#define C2D_SOLVE_HERE body, id, kicked, listStart, other, memory, bucketStart, status, levels, rule

// The lists of the circles of one bucket, one after the other.
static void c2d_solve_bucket(int bucket, C2D_SOLVE) {
    int i = bucketStart[bucket];
    const int last = bucketStart[bucket + 1];
    int k = listStart[i];
    const int end = listStart[last];
    while (k < end) {
        int listEnd = listStart[i + 1];
        while (listEnd == k) {
            i++;
            listEnd = listStart[i + 1];
        }
        float8 a = body[i];
        for (; k < listEnd; k++) {
            a = c2d_visit(a, i, k, body, id, kicked, other, memory, rule);
        }
        body[i] = a;
        i++;
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
    c2d_solve_bucket(level.C2D_BASE + row * level.C2D_WIDTH + x + 3 * (item % across), C2D_SOLVE_HERE);
}

// The levels from `firstLevel` on, all of their colours, in one launch of one work-group: where buckets are few, launches
// would cost more than the work.
__kernel void c2d_solve_narrow(C2D_SOLVE, int firstLevel, int levelCount) {
    const bool stalled = status[C2D_STALLED] != 0u;
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
                c2d_solve_bucket(level.C2D_BASE + row * level.C2D_WIDTH + x + 3 * (item % across), C2D_SOLVE_HERE);
            }
            barrier(CLK_GLOBAL_MEM_FENCE);
        }
    }
}

static float2 c2d_rescaled(float come, float last, float ratio) {
    return (float2)(come * ratio, last > 0.0f ? last * ratio : last);
}

// What impulses are worth in substeps of another time. One work-item a circle, going round where contacts are more.
__kernel void c2d_rescale(__global float8 *body, __global float *walls, __global float2 *memory,
                          __global const int *listStart, int circles, __global const float *rule) {
    const float ratio = C2D_RESCALE;
    const int i = (int)get_global_id(0);
    const int contacts = listStart[circles];
    for (int k = i; k < contacts; k += (int)get_global_size(0)) {
        memory[k] = c2d_rescaled(memory[k].x, memory[k].y, ratio);
    }
    if (i < circles) {
        for (int wall = 8 * i; wall < 8 * i + 4; wall++) {
            const float2 rescaled = c2d_rescaled(walls[wall], walls[wall + 4], ratio);
            walls[wall] = rescaled.x;
            walls[wall + 4] = rescaled.y;
        }
        body[i].s4 *= ratio;
        body[i].s5 *= ratio;
    }
}
