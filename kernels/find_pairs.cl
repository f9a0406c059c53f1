// Stage find by the index strategy, one work-item a pair. Twin of host.Find.

static void c2d_find_pair(C2D_FIND, __global const int2 *table, ulong first, ulong pairs, float horizon, float slack,
                          bool fill) {
    const size_t item = get_global_id(0);
    if (item >= pairs || status[C2D_STALLED] != 0u) {
        return;
    }
    const int2 pair = c2d_pair_at((c2d_index)first + (c2d_index)item, (c2d_index)first, circles, table);
    const float8 bodyA = body[pair.x];
    const float8 bodyB = body[pair.y];
    if (!c2d_near(bodyA, bodyB, numbers.alwaysNear, horizon, slack)) {
        return;
    }
    const int4 a = c2d_cell(bodyA, levels, numbers);
    const int4 b = c2d_cell(bodyB, levels, numbers);
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

__kernel void c2d_find_count(C2D_WORLD, __global const int2 *table, ulong first, ulong pairs, float horizon, float slack) {
    c2d_find_pair(C2D_FIND_HERE, table, first, pairs, horizon, slack, false);
}

__kernel void c2d_find_fill(C2D_WORLD, __global const int2 *table, ulong first, ulong pairs, float horizon, float slack) {
    c2d_find_pair(C2D_FIND_HERE, table, first, pairs, horizon, slack, true);
}
