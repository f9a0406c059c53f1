// Stage find by the grid, one work-item a circle. Twin of host.Find.

// Of each circle the first so many pairs that it counts are kept, so that it need not look for them again: in `kept`, where the
// circles were before they were sorted, the other circle, or its complement where that one is smaller and lists the pair; how
// many there were is at the start of `filled`.
#define C2D_KEPT 8
#define C2D_KEPT_PAIRS C2D_AT(int, bodyBefore)

// Candidates that are read at once: on a GPU each is a long way to memory, on a processor several only fill the registers.
#if C2D_GPU
#define C2D_AT_ONCE 4
#define C2D_CANDIDATE there[turn]
#else
#define C2D_AT_ONCE 1
#define C2D_CANDIDATE there
#endif

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
static void c2d_find_around(int i, C2D_FIND, __global const int *bucketStart, __global int *kept, float horizon, float slack,
                            bool fill) {
    const float8 own = body[i];
    const int4 ownCell = c2d_cell(own, levels, numbers);
    const int levelCount = levels[0].C2D_LEVELS;
    const int end = fill ? listStart[i + 1] : 0;
    // who fills comes here seldom, and compilers take their time over several
    const int atOnce = fill ? 1 : C2D_AT_ONCE;
    const float always = numbers.alwaysNear;
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
                for (int last = bucketStart[bucket + 1] - 1; last >= first; last -= atOnce) {
#if C2D_GPU
                    float8 there[C2D_AT_ONCE];
                    for (int turn = 0; turn < atOnce; turn++) {
                        there[turn] = body[max(last - turn, first)];
                    }
#else
                    const float8 there = body[last];
#endif
                    // few are near: without a branch for each of the others
                    uint near = 0u;
                    for (int turn = 0; turn < atOnce; turn++) {
                        near |= (uint)(last - turn >= first && c2d_near(own, C2D_CANDIDATE, always, horizon, slack)) << turn;
                    }
                    for (; near != 0u; near &= near - 1u) {
                        const int j = last - 31 + (int)clz(near & -near);
                        if (folded) {
                            // a bucket holds circles of cells far apart
                            const int4 cell = c2d_cell(body[j], levels, numbers);
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
    }
    if (!fill) {
        filled[i] = pairs;
        atomic_add(&listStart[i + 1], free);
    }
}

__kernel void c2d_find_count(C2D_WORLD, float horizon, float slack) {
    const int i = (int)get_global_id(0);
    if (i < world.circles && status[C2D_STALLED] == 0u) {
        c2d_find_around(i, C2D_FIND_HERE, C2D_BUCKET_START, C2D_KEPT_PAIRS, horizon, slack, false);
    }
}

__kernel void c2d_find_fill(C2D_WORLD, float horizon, float slack) {
    const int i = (int)get_global_id(0);
    const int circles = world.circles;
    if (i >= circles || status[C2D_STALLED] != 0u) {
        return;
    }
    const int pairs = C2D_FILLED[i];
    if (pairs > C2D_KEPT) {
        c2d_find_around(i, C2D_FIND_HERE, C2D_BUCKET_START, C2D_KEPT_PAIRS, horizon, slack, true);
        return;
    }
    const bool folded = pairs > 0 && c2d_is_folded(C2D_LEVEL_TABLE[1 + c2d_cell(C2D_BODY[i], C2D_LEVEL_TABLE, world.numbers).z]);
    const int end = C2D_LIST_START[i + 1];
    int free = end;
    for (int k = 0; k < pairs; k++) {
        const int j = C2D_KEPT_PAIRS[k * circles + i];
        if (j >= 0) {
            free = c2d_find_put(i, j, free, end, folded, C2D_OTHER, C2D_FOUND);
        } else {
            c2d_find_put_smaller(i, ~j, circles, C2D_LIST_START, C2D_FILLED, C2D_FOUND);
        }
    }
}
