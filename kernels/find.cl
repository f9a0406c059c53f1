// Lists the pairs of circles that may touch before the next detection, those of neighbouring cells of the wider of their two
// levels. By the grid, one work-item a circle; or by the index strategy, one work-item a pair. Twice: to count, and to fill
// the lists. Twin of host.Find.

// What find knows. `filled`, from `circles` on: how much of each list is filled from its start; `found`: of each contact the
// other circle and the one in whose list it is.
#define C2D_FIND                                                                                                       \
    __global const float8 *body, __global const int8 *levels, __global const float *rule, __global const uint *status,   \
        int circles, __global int *listStart, __global int *filled, __global int *other, __global int2 *found

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

#if C2D_PAIRWISE
static void c2d_find_pair(C2D_FIND, __global const int2 *table, ulong first, ulong pairs, float horizon, float fall,
                          bool fill) {
    const size_t item = get_global_id(0);
    if (item >= pairs || status[C2D_STALLED] != 0u) {
        return;
    }
    const int2 pair = c2d_pair_at((c2d_index)first + (c2d_index)item, (c2d_index)first, circles, table);
    const float8 bodyA = body[pair.x];
    const float8 bodyB = body[pair.y];
    if (!c2d_near(bodyA, bodyB, rule, horizon, fall)) {
        return;
    }
    const int4 a = c2d_cell(bodyA, levels, rule);
    const int4 b = c2d_cell(bodyB, levels, rule);
    const int shift = levels[1 + max(a.z, b.z)].C2D_SHIFT;
    const int dx = (a.x >> shift) - (b.x >> shift);
    const int dy = (a.y >> shift) - (b.y >> shift);
    if (abs(dx) > 1u || abs(dy) > 1u) {
        return;
    }
    const bool lower = dy < 0 || (dy == 0 && (dx < 0 || (dx == 0 && pair.x < pair.y)));
    const bool isFirst = a.z > b.z || (a.z == b.z && lower);
    const int lists = isFirst ? pair.x : pair.y;
    if (fill) {
        found[listStart[lists] + atomic_inc(&filled[circles + lists])] = (int2)(isFirst ? pair.y : pair.x, lists);
    } else {
        atomic_inc(&listStart[lists + 1]);
    }
}

__kernel void c2d_find_count(C2D_FIND, __global const int2 *table, ulong first, ulong pairs, float horizon, float fall) {
    c2d_find_pair(body, levels, rule, status, circles, listStart, filled, other, found, table, first, pairs, horizon,
                  fall, false);
}

__kernel void c2d_find_fill(C2D_FIND, __global const int2 *table, ulong first, ulong pairs, float horizon, float fall) {
    c2d_find_pair(body, levels, rule, status, circles, listStart, filled, other, found, table, first, pairs, horizon,
                  fall, true);
}
#else
// Of each circle the first so many pairs that it counts are kept, so that it need not look for them again: in `kept`, where the
// circles were before they were sorted, the other circle, or its complement where that one is smaller and lists the pair; how
// many there were is at the start of `filled`.
#define C2D_KEPT 8

// Puts circle j into the list of circle i, which fills up from its `end`; returns what is still free.
static int c2d_find_put(int i, int j, int free, int end, bool folded, __global int *other, __global int2 *found) {
    int at = free - 1;
    found[at] = (int2)(j, i);
    // only a folded level is not in order yet
    for (; folded && at + 1 < end && other[at + 1] < j; at++) {
        other[at] = other[at + 1];
    }
    other[at] = j;
    return free - 1;
}

static void c2d_find_put_smaller(int i, int j, int circles, __global const int *listStart, __global int *filled,
                                 __global int2 *found) {
    found[listStart[j] + atomic_inc(&filled[circles + j])] = (int2)(i, j);
}

// Circle i looks into half of the cells around its own, and into all of those of wider levels: from the last to the first,
// so that its own list fills up from its end.
static void c2d_find_around(int i, C2D_FIND, __global const int *bucketStart, __global int *kept, float horizon, float fall,
                            bool fill) {
    const float8 own = body[i];
    const int4 ownCell = c2d_cell(own, levels, rule);
    const int levelCount = levels[0].C2D_LEVELS;
    const int end = fill ? listStart[i + 1] : 0;
    int free = end;
    int pairs = 0;
    for (int number = ownCell.z; number < levelCount; number++) {
        const int8 level = levels[1 + number];
        const bool same = number == ownCell.z;
        const bool folded = c2d_is_folded(level);
        const int x = ownCell.x >> level.C2D_SHIFT;
        const int y = ownCell.y >> level.C2D_SHIFT;
        const int right = min(x + 1, level.C2D_LAST_X);
        for (int row = min(y + 1, level.C2D_LAST_Y); row >= max(same ? y : y - 1, 0); row--) {
            // cells of a row are next to each other, save where the level is folded
            const int left = same && row == y ? x : max(x - 1, 0);
            for (int column = right; column >= left; column = folded ? column - 1 : -1) {
                const int bucket = c2d_bucket(level, column, row);
                const int firstBucket = folded ? bucket : bucket - (right - left);
                const bool home = same && row == y && (!folded || column == x);
                const int first = home ? i + 1 : bucketStart[firstBucket];
                for (int j = bucketStart[bucket + 1] - 1; j >= first; j--) {
                    const float8 there = body[j];
                    if (!c2d_near(own, there, rule, horizon, fall)) {
                        continue;
                    }
                    if (folded) {
                        // a bucket holds circles of cells far apart
                        const int4 cell = c2d_cell(there, levels, rule);
                        if (cell.x >> level.C2D_SHIFT != column || cell.y >> level.C2D_SHIFT != row) {
                            continue;
                        }
                    }
                    if (fill) {
                        if (same) {
                            free = c2d_find_put(i, j, free, end, folded, other, found);
                        } else {
                            c2d_find_put_smaller(i, j, circles, listStart, filled, found);
                        }
                        continue;
                    }
                    if (same) {
                        free++;
                    } else {
                        atomic_inc(&listStart[j + 1]);
                    }
                    if (pairs < C2D_KEPT) {
                        kept[pairs * circles + i] = same ? j : ~j;
                    }
                    pairs++;
                }
            }
        }
    }
    if (!fill) {
        filled[i] = pairs;
        atomic_add(&listStart[i + 1], free);
    }
}

__kernel void c2d_find_count(C2D_FIND, __global const int *bucketStart, __global int *kept, float horizon, float fall) {
    const int i = (int)get_global_id(0);
    if (i < circles && status[C2D_STALLED] == 0u) {
        c2d_find_around(i, body, levels, rule, status, circles, listStart, filled, other, found, bucketStart, kept,
                        horizon, fall, false);
    }
}

__kernel void c2d_find_fill(C2D_FIND, __global const int *bucketStart, __global int *kept, float horizon, float fall) {
    const int i = (int)get_global_id(0);
    if (i >= circles || status[C2D_STALLED] != 0u) {
        return;
    }
    const int pairs = filled[i];
    if (pairs > C2D_KEPT) {
        c2d_find_around(i, body, levels, rule, status, circles, listStart, filled, other, found, bucketStart, kept,
                        horizon, fall, true);
        return;
    }
    const bool folded = pairs > 0 && c2d_is_folded(levels[1 + c2d_cell(body[i], levels, rule).z]);
    const int end = listStart[i + 1];
    int free = end;
    for (int k = 0; k < pairs; k++) {
        const int j = kept[k * circles + i];
        if (j >= 0) {
            free = c2d_find_put(i, j, free, end, folded, other, found);
        } else {
            c2d_find_put_smaller(i, ~j, circles, listStart, filled, found);
        }
    }
}
#endif

// After a detection that stalled, where there were more pairs than room: puts the circles back to where they were before it,
// for what is kept has taken their place.
__kernel void c2d_find_restore(__global const float8 *body, __global const int *from, int circles,
                               __global float8 *bodyBefore) {
    const int p = (int)get_global_id(0);
    if (p < circles) {
        bodyBefore[from[p]] = body[p];
    }
}
