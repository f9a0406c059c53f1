// Lists the pairs of circles that may touch before the next detection, those of neighbouring cells of the wider of their two
// levels. By the grid, one work-item a circle; or by the index strategy, one work-item a pair. Twice: to count, and to fill
// the lists. Twin of host.Find.

// What find knows. `filled`: which of its candidates a circle lists; from `circles` on, how much of each list is filled from its
// start. `found`: of each contact the other circle and the one in whose list it is.
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
// The candidates of circle i on its own level where that is not folded: places first.x .. first.y - 1, of its row of cells, and
// second.x .. second.y - 1, of the next.
typedef struct {
    int2 first;
    int2 second;
} c2d_candidates;

static c2d_candidates c2d_candidates_of(int i, int8 level, int x, int y, __global const int *bucketStart) {
    const int left = max(x - 1, 0);
    const int right = min(x + 1, level.C2D_LAST_X);
    c2d_candidates these = {(int2)(i + 1, bucketStart[c2d_bucket(level, right, y) + 1]), (int2)(0, 0)};
    if (y < level.C2D_LAST_Y) {
        these.second = (int2)(bucketStart[c2d_bucket(level, left, y + 1)],
                              bucketStart[c2d_bucket(level, right, y + 1) + 1]);
    }
    return these;
}

// Where circle j is not on the level of circle i, or that level is folded: looks at one of them.
static void c2d_find_one(int i, int j, float8 own, int column, int row, int8 level, bool same, bool folded, int *free,
                         int end, C2D_FIND, float horizon, float fall, bool fill) {
    const float8 there = body[j];
    if (!c2d_near(own, there, rule, horizon, fall)) {
        return;
    }
    if (folded) {
        // a bucket holds circles of cells far apart
        const int4 cell = c2d_cell(there, levels, rule);
        if (cell.x >> level.C2D_SHIFT != column || cell.y >> level.C2D_SHIFT != row) {
            return;
        }
    }
    if (!same) {
        if (fill) {
            found[listStart[j] + atomic_inc(&filled[circles + j])] = (int2)(i, j);
        } else {
            atomic_inc(&listStart[j + 1]);
        }
        return;
    }
    *free -= 1;
    if (fill) {
        found[*free] = (int2)(j, i);
        int at = *free;
        for (; at + 1 < end && other[at + 1] < j; at++) {
            other[at] = other[at + 1];
        }
        other[at] = j;
    }
}

// Circle i looks into all of the cells around its own of wider levels, and into half of those of its own level where that is
// folded: from the last to the first, so that its own list fills up from its end, which is `free`.
static int c2d_find_around(int i, float8 own, int4 ownCell, bool folds, int free, C2D_FIND,
                           __global const int *bucketStart, float horizon, float fall, bool fill) {
    const int end = free;
    const int levelCount = levels[0].C2D_LEVELS;
    for (int number = folds ? ownCell.z : ownCell.z + 1; number < levelCount; number++) {
        const int8 level = levels[1 + number];
        const bool same = number == ownCell.z;
        const bool folded = c2d_is_folded(level);
        const int x = ownCell.x >> level.C2D_SHIFT;
        const int y = ownCell.y >> level.C2D_SHIFT;
        for (int row = min(y + 1, level.C2D_LAST_Y); row >= max(same ? y : y - 1, 0); row--) {
            const int left = same && row == y ? x : max(x - 1, 0);
            for (int column = min(x + 1, level.C2D_LAST_X); column >= left; column--) {
                const int bucket = c2d_bucket(level, column, row);
                const int first = same && row == y && column == x ? i + 1 : bucketStart[bucket];
                for (int j = bucketStart[bucket + 1] - 1; j >= first; j--) {
                    c2d_find_one(i, j, own, column, row, level, same, folded, &free, end, body, levels, rule, status,
                                 circles, listStart, filled, other, found, horizon, fall, fill);
                }
            }
        }
    }
    return free;
}

// Also remembers, as bits, which of a circle's candidates it lists, in `filled`, up to `circles`; -1 where they are too many.
__kernel void c2d_find_count(C2D_FIND, __global const int *bucketStart, float horizon, float fall) {
    const int i = (int)get_global_id(0);
    if (i >= circles || status[C2D_STALLED] != 0u) {
        return;
    }
    const float8 own = body[i];
    const int4 cell = c2d_cell(own, levels, rule);
    const int8 level = levels[1 + cell.z];
    const bool folds = c2d_is_folded(level);
    int count = -c2d_find_around(i, own, cell, folds, 0, body, levels, rule, status, circles, listStart, filled, other,
                                 found, bucketStart, horizon, fall, false);
    if (!folds) {
        const c2d_candidates these =
            c2d_candidates_of(i, level, cell.x >> level.C2D_SHIFT, cell.y >> level.C2D_SHIFT, bucketStart);
        const int turn = these.first.y - these.first.x;
        const int all = turn + these.second.y - these.second.x;
        uint listed = 0u;
        for (int c = 0; c < all; c++) {
            const int j = c < turn ? these.first.x + c : these.second.x + c - turn;
            const bool near = c2d_near(own, body[j], rule, horizon, fall);
            count += near ? 1 : 0;
            listed |= near && c < 31 ? 1u << c : 0u;
        }
        filled[i] = all > 31 ? -1 : (int)listed;
    }
    atomic_add(&listStart[i + 1], count);
}

__kernel void c2d_find_fill(C2D_FIND, __global const int *bucketStart, float horizon, float fall) {
    const int i = (int)get_global_id(0);
    if (i >= circles || status[C2D_STALLED] != 0u) {
        return;
    }
    const float8 own = body[i];
    const int4 cell = c2d_cell(own, levels, rule);
    const int8 level = levels[1 + cell.z];
    const bool folds = c2d_is_folded(level);
    int free = c2d_find_around(i, own, cell, folds, listStart[i + 1], body, levels, rule, status, circles, listStart,
                               filled, other, found, bucketStart, horizon, fall, true);
    if (!folds) {
        const c2d_candidates these =
            c2d_candidates_of(i, level, cell.x >> level.C2D_SHIFT, cell.y >> level.C2D_SHIFT, bucketStart);
        const int turn = these.first.y - these.first.x;
        const int listed = filled[i];
        for (int c = turn + these.second.y - these.second.x - 1; c >= 0; c--) {
            const int j = c < turn ? these.first.x + c : these.second.x + c - turn;
            if (listed >= 0 ? (listed >> c & 1) != 0 : c2d_near(own, body[j], rule, horizon, fall)) {
                free--;
                found[free] = (int2)(j, i);
                other[free] = j;
            }
        }
    }
}
#endif
