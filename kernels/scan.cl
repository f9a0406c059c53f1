// Turns counts into sums: each value becomes the sum of all up to it. Many values take three launches: parts, one a work-group;
// the sums of the parts, one work-group; the sums added to the parts. Few take one launch of one work-group. Integers alone, so
// that the size of a group leaves no trace.

__kernel void c2d_scan_parts(__global int *values, int all, __global int *partSums, __global const uint *status,
                             __local int *sums) {
    // in a step that has stalled, these are the values of the detection before: they are still needed
    const int count = status[C2D_STALLED] != 0u ? 0 : all;
    const int first = (int)get_global_id(0) * C2D_SCAN;
    const int sum = c2d_scan_part(values, first, count, 0, sums);
    if (get_local_id(0) == get_local_size(0) - 1) {
        partSums[get_group_id(0)] = sum;
    }
}

// The one place that stalls a detection until there is room: where the values are the lengths of lists, with room for `capacity`
// contacts; -1 for other values.
static void c2d_scan_check(int contacts, int capacity, __global uint *status) {
    if (get_local_id(0) == 0 && capacity >= 0 && status[C2D_STALLED] == 0u) {
        status[C2D_CONTACTS] = (uint)contacts;
        status[C2D_STALLED] = contacts > capacity ? 1u : 0u;
    }
}

__kernel void c2d_scan_sums(__global int *partSums, int parts, __global uint *status, int capacity,
                            __local int *sums) {
    c2d_scan_check(c2d_scan_group(partSums, parts, sums), capacity, status);
}

__kernel void c2d_scan_few(__global int *values, int all, __global uint *status, int capacity, __local int *sums) {
    const int count = status[C2D_STALLED] != 0u ? 0 : all;
    c2d_scan_check(c2d_scan_group(values, count, sums), capacity, status);
}

__kernel void c2d_scan_add(__global int *values, int count, __global const int *partSums,
                           __global const uint *status, int perPart) {
    const int k = (int)get_global_id(0);
    if (k >= perPart && k < count && status[C2D_STALLED] == 0u) {
        values[k] = add_sat(values[k], partSums[k / perPart - 1]);
    }
}
