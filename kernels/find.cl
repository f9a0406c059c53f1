// Lists the pairs of circles that may touch before the next detection, those of neighbouring cells of the wider of their two
// levels. By the grid, one work-item a circle; or by the index strategy, one work-item a pair. Twin of host.Find.

// What find knows, in the order in which the kernels take it.
#define C2D_FOUND                                                                                                      \
    __global const float8 *body, __global const int *id, __global const int4 *cell, __global const int8 *levels,       \
        __global const float *rule, __global int *ownerStart, __global int4 *found, __global int *foundOwner,          \
        __global uint *status, uint capacity
#define C2D_FOUND_HERE body, id, cell, levels, rule, ownerStart, found, foundOwner, status, capacity

// Whether two circles may touch within the horizon, in which gravity can part them by `fall`; the same whichever comes first.
static bool c2d_near(float8 a, float8 b, __global const float *rule, float horizon, float fall) {
    const float dx = a.s0 - b.s0;
    const float dy = a.s1 - b.s1;
    const float dvx = a.s2 - b.s2;
    const float dvy = a.s3 - b.s3;
    const float travel = sqrt(dvx * dvx + dvy * dvy) * horizon;
    const float smaller = a.s6 < b.s6 ? a.s6 : b.s6;
    const float reach = a.s6 + b.s6 + C2D_ALWAYS_NEAR * smaller + fall + travel;
    return dx * dx + dy * dy < reach * reach;
}

// A contact as it is found is an int4: the places of its circles, lower number first, and their numbers.
static void c2d_find_append(int i, int j, int owner, C2D_FOUND) {
#if C2D_WIDE
    if (atomic_add(&status[C2D_CONTACTS], 0u) > (uint)INT_MAX) {
        return;
    }
#endif
    const uint slot = atomic_inc(&status[C2D_CONTACTS]);
    if (slot < capacity) {
        const int a = id[i];
        const int b = id[j];
        found[slot] = a < b ? (int4)(i, j, a, b) : (int4)(j, i, b, a);
        foundOwner[slot] = owner;
        atomic_inc(&ownerStart[owner]);
    }
}

#if C2D_PAIRWISE
__kernel void c2d_find_pairs(C2D_FOUND, __global const int2 *table, int circles, ulong first, ulong pairs, float horizon,
                             float fall) {
    const size_t item = get_global_id(0);
    if (item >= pairs || status[C2D_STALLED] != 0u) {
        return;
    }
    const int2 pair = c2d_pair_at((c2d_index)first + (c2d_index)item, (c2d_index)first, circles, table);
    if (c2d_near(body[pair.x], body[pair.y], rule, horizon, fall)) {
        const int4 a = cell[id[pair.x]];
        const int4 b = cell[id[pair.y]];
        const int8 level = levels[max(a.z, b.z)];
        const int owner = c2d_owner_of_two(level, a.xy >> level.C2D_SHIFT, b.xy >> level.C2D_SHIFT);
        if (owner >= 0) {
            c2d_find_append(pair.x, pair.y, owner, C2D_FOUND_HERE);
        }
    }
}
#else
// Looks into half of the cells around a circle's own, and into all of those of wider levels.
__kernel void c2d_find(C2D_FOUND, __global const int *bucketStart, int circles, int levelCount, float horizon,
                       float fall) {
    const int i = (int)get_global_id(0);
    if (i >= circles || status[C2D_STALLED] != 0u) {
        return;
    }
    const float8 own = body[i];
    const int4 ownCell = cell[id[i]];
    for (int number = ownCell.z; number < levelCount; number++) {
        const int8 level = levels[number];
        const bool same = number == ownCell.z;
        const int2 at = ownCell.xy >> level.C2D_SHIFT;
        for (int dy = same ? 0 : -1; dy <= 1; dy++) {
            for (int dx = same && dy == 0 ? 0 : -1; dx <= 1; dx++) {
                const int2 other = at + (int2)(dx, dy);
                if (other.x < 0 || other.y < 0 || other.x > level.C2D_LAST_X || other.y > level.C2D_LAST_Y) {
                    continue;
                }
                const int bucket = c2d_bucket(level, other);
                const int end = bucketStart[bucket + 1];
                for (int j = same && dx == 0 && dy == 0 ? i + 1 : bucketStart[bucket]; j < end; j++) {
                    if (c2d_near(own, body[j], rule, horizon, fall)) {
                        // a bucket of a folded level holds circles of cells far apart
                        const int2 there = cell[id[j]].xy >> level.C2D_SHIFT;
                        if (there.x == other.x && there.y == other.y) {
                            c2d_find_append(i, j, c2d_owner_of_two(level, at, other), C2D_FOUND_HERE);
                        }
                    }
                }
            }
        }
    }
}
#endif
