// One pass over the contacts: Solver.SMALL_STEPS; the rule of one contact is in visit.cl. Twin of host.Solve.

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
