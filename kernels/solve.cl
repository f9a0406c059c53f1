// One pass over the contacts, in the order that match made: Solver.SMALL_STEPS. Twin of host.Solve.

static void c2d_visit(uint k, __global float8 *body, __global const float2 *kicked, __global const int2 *pair,
                      __global const int2 *ids, __global float2 *memory, __global const float *rule) {
    const int2 at = pair[k];
    float8 a = body[at.x];
    float8 b = body[at.y];
    const float dx = a.s0 - b.s0;
    const float dy = a.s1 - b.s1;
    const float distance = sqrt(dx * dx + dy * dy);
    // the normal points to the first circle
    const float2 normal =
        distance > 0.0f ? (float2)(dx / distance, dy / distance) : c2d_direction(ids[k].x, ids[k].y);
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
        impulse = 0.0f;
    } else if (come == 0.0f) {
        const float2 ua = kicked[at.x];
        const float2 ub = kicked[at.y];
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
    body[at.x] = a;
    body[at.y] = b;
    memory[k] = (float2)(next, bounced ? -1.0f : impulse);
}

// The owners of one colour of one level. One work-item an owner, its contacts in turn.
__kernel void c2d_solve(__global float8 *body, __global const float2 *kicked, __global const int2 *pair,
                        __global const int2 *ids, __global float2 *memory, __global const int *ownerStart,
                        __global const uint *status, __global const float *rule, int firstOwner, int owners) {
    const int item = (int)get_global_id(0);
    if (item >= owners || status[C2D_STALLED] != 0u) {
        return;
    }
    const int end = ownerStart[firstOwner + item + 1];
    for (int k = ownerStart[firstOwner + item]; k < end; k++) {
        c2d_visit((uint)k, body, kicked, pair, ids, memory, rule);
    }
}

// The levels from `firstLevel` on, all of their colours, in one launch of one work-group: where owners are few, launches would
// cost more than the work.
__kernel void c2d_solve_narrow(__global float8 *body, __global const float2 *kicked, __global const int2 *pair,
                               __global const int2 *ids, __global float2 *memory, __global const int *ownerStart,
                               __global const uint *status, __global const float *rule, __global const int8 *levels,
                               int firstLevel, int levelCount) {
    const bool stalled = status[C2D_STALLED] != 0u;
    for (int number = firstLevel; number < levelCount; number++) {
        const int owners = stalled ? 0 : levels[number].C2D_OWNERS;
        const int base = levels[number].C2D_BASE;
        for (int colour = 0; colour < 6; colour++) {
            const int first = base + colour * owners;
            for (int item = (int)get_local_id(0); item < owners; item += (int)get_local_size(0)) {
                const int end = ownerStart[first + item + 1];
                for (int k = ownerStart[first + item]; k < end; k++) {
                    c2d_visit((uint)k, body, kicked, pair, ids, memory, rule);
                }
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
                          __global const int *ownerStart, int cells, int circles, __global const float *rule) {
    const float ratio = C2D_RESCALE;
    const int i = (int)get_global_id(0);
    const int contacts = ownerStart[cells];
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
