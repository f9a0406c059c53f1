// Finds the circles that overlap and the vector that parts them (thesis, chapter 4, kernels 2 to 4).
// One work-item for C2D_PAIRS pairs: far apart, so that neighbours look at neighbours, or, where a processor lists contacts, one after the
// other. Which circles they are, the index strategy says.

// A unit vector for two circles with one centre: fixed by their numbers, different for each pair.
static float2 c2d_direction(int i, int j) {
    uint h = (uint)i * 0x9E3779B1u ^ (uint)j * 0x85EBCA77u;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    h ^= h >> 15;
    const float x = (float)(h & 0xFFFFu) - 32767.5f;
    const float y = (float)(h >> 16) - 32767.5f;
    const float length = sqrt(x * x + y * y);
    return (float2)(x / length, y / length);
}

// Whether two circles are nearer than their radii; nearly all pairs are not.
static bool c2d_reaches(float4 a, float4 b) {
    const float dx = b.x - a.x;
    const float dy = b.y - a.y;
    const float reach = a.z + b.z;
    return dx * dx + dy * dy < reach * reach;
}

// The minimum translation vector, pointing from i to j; zero where the two do not overlap. Twin of host.Detect.
static float2 c2d_translation(float4 a, float4 b, int i, int j) {
    const float dx = b.x - a.x;
    const float dy = b.y - a.y;
    const float reach = a.z + b.z;
    const float square = dx * dx + dy * dy;
    if (!c2d_reaches(a, b)) {
        return (float2)(0.0f, 0.0f);
    }
    const float distance = sqrt(square);
    const float depth = reach - distance;
    if (!(depth > 0.0f)) {
        return (float2)(0.0f, 0.0f);
    }
    const float2 normal = distance > 0.0f ? (float2)(dx / distance, dy / distance) : c2d_direction(i, j);
    return (float2)(depth * normal.x, depth * normal.y);
}

// Lists a contact of two circles if they overlap.
static void c2d_contact(float4 a, float4 b, int2 pair, __global int4 *found, __global uint *status, uint capacity) {
    const float2 translation = c2d_translation(a, b, pair.x, pair.y);
    if (translation.x != 0.0f || translation.y != 0.0f) {
        c2d_append(pair, translation, found, status, capacity);
    }
}

#if C2D_PAIRWISE
// The work-items of a slice of the pairs: first .. first + pairs - 1.
#if C2D_TRIANGLE
__kernel void c2d_detect(__global const float4 *circle, __global const int2 *table, __global const uint *status,
                         int circles, ulong first, ulong pairs, __global float2 *collision, __global uint *mark) {
#else
__kernel void c2d_detect(__global const float4 *circle, __global const int2 *table, __global uint *status,
                         int circles, ulong first, ulong pairs, __global int4 *found, uint capacity) {
#endif
    if (status[C2D_STALLED] != 0u) {
        return;
    }
    const c2d_index stride = (c2d_index)((pairs + C2D_PAIRS - 1) / C2D_PAIRS);
    const c2d_index item = (c2d_index)get_global_id(0);
    if (item >= stride) {
        return;
    }
#if C2D_TRIANGLE
#pragma unroll
    for (int turn = 0; turn < C2D_PAIRS; turn++) {
        const c2d_index own = item + (c2d_index)turn * stride;
        if (own < (c2d_index)pairs) {
            const int2 pair = c2d_pair_at((c2d_index)first + own, (c2d_index)first, circles, table);
            const float2 translation = c2d_translation(circle[pair.x], circle[pair.y], pair.x, pair.y);
            collision[own] = translation;
            if (translation.x != 0.0f || translation.y != 0.0f) {
                // the number of this step: marks of earlier ones need no clearing
                atomic_xchg(&mark[own / C2D_BLOCK], status[C2D_UPDATES]);
            }
        }
    }
#elif !C2D_GPU
    const c2d_index from = item * C2D_PAIRS;
    const c2d_index end = min(from + C2D_PAIRS, (c2d_index)pairs);
    for (c2d_index own = from; own < end; own++) {
        const int2 pair = c2d_pair_at((c2d_index)first + own, (c2d_index)first, circles, table);
        if (c2d_reaches(circle[pair.x], circle[pair.y])) {
            c2d_contact(circle[pair.x], circle[pair.y], pair, found, status, capacity);
        }
    }
#else
    // first all of them without a branch, which processors take longer for; a pair that is none is the first one again
    int2 pair[C2D_PAIRS];
    uint reach = 0u;
#pragma unroll
    for (int turn = 0; turn < C2D_PAIRS; turn++) {
        const c2d_index own = item + (c2d_index)turn * stride;
        const bool is = own < (c2d_index)pairs;
        pair[turn] = c2d_pair_at((c2d_index)first + (is ? own : item), (c2d_index)first, circles, table);
        reach |= (uint)(is & c2d_reaches(circle[pair[turn].x], circle[pair[turn].y])) << turn;
    }
    if (reach == 0u) {
        return;
    }
#pragma unroll
    for (int turn = 0; turn < C2D_PAIRS; turn++) {
        if ((reach >> turn & 1u) != 0u) {
            c2d_contact(circle[pair[turn].x], circle[pair[turn].y], pair[turn], found, status, capacity);
        }
    }
#endif
}
#endif
