// Turns counts into sums: each value becomes the sum of all up to it. Many values take three launches: parts, one a work-group;
// the sums of the parts, one work-group; the sums added to the parts. Few take one launch of one work-group. Integers alone, so
// that the size of a group leaves no trace.

#define C2D_PART_SUMS C2D_AT(int, partSums)
#define C2D_VALUES ((__global int *)(heap + 32ul * values))

__kernel void c2d_scan_parts(C2D_WORLD, uint values, int all, __local int *sums) {
    // in a step that has stalled, these are the values of the detection before: they are still needed
    const int count = status[C2D_STALLED] != 0u ? 0 : all;
    const int first = (int)get_global_id(0) * C2D_SCAN;
    const int sum = c2d_scan_part(C2D_VALUES, first, count, 0, sums);
    if (get_local_id(0) == get_local_size(0) - 1) {
        C2D_PART_SUMS[get_group_id(0)] = sum;
    }
}

// The one place that stalls a detection until there is room: where the values are the lengths of lists, `isLists`, which add up
// to more contacts than there is room for.
static void c2d_scan_check(int contacts, int isLists, int capacity, __global uint *status) {
    if (get_local_id(0) == 0 && isLists && status[C2D_STALLED] == 0u) {
        status[C2D_CONTACTS] = (uint)contacts;
        status[C2D_STALLED] = contacts > capacity ? 1u : 0u;
    }
}

__kernel C2D_ONE void c2d_scan_sums(C2D_WORLD, int parts, int isLists, __local int *sums) {
    c2d_scan_check(c2d_scan_group(C2D_PART_SUMS, parts, sums), isLists, world.capacity, status);
}

__kernel C2D_ONE void c2d_scan_few(C2D_WORLD, uint values, int all, int isLists, __local int *sums) {
    const int count = status[C2D_STALLED] != 0u ? 0 : all;
    c2d_scan_check(c2d_scan_group(C2D_VALUES, count, sums), isLists, world.capacity, status);
}

__kernel void c2d_scan_add(C2D_WORLD, uint values, int count, int perPart) {
    const int k = (int)get_global_id(0);
    if (k >= perPart && k < count && status[C2D_STALLED] == 0u) {
        C2D_VALUES[k] = add_sat(C2D_VALUES[k], C2D_PART_SUMS[k / perPart - 1]);
    }
}
