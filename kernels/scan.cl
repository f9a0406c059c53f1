// Turns counts into sums: each value becomes the sum of all up to it. Three launches, whatever the number of values:
// parts, one a work-group; the sums of the parts, one work-group; the sums added to the parts. Integers alone, so that the
// size of a group leaves no trace.

// The values that one work-item has of those of its group.
static int c2d_scan_part(__global int *values, int first, int end, __local int *sums) {
    const int item = (int)get_local_id(0);
    int own = 0;
    for (int k = first; k < end; k++) {
        own += values[k];
    }
    sums[item] = own;
    for (int step = 1; step < (int)get_local_size(0); step *= 2) {
        barrier(CLK_LOCAL_MEM_FENCE);
        const int before = item >= step ? sums[item - step] : 0;
        barrier(CLK_LOCAL_MEM_FENCE);
        sums[item] += before;
    }
    int sum = sums[item] - own;
    for (int k = first; k < end; k++) {
        sum += values[k];
        values[k] = sum;
    }
    return sum;
}

__kernel void c2d_scan_parts(__global int *values, int all, __global int *partSums, __global const uint *status,
                             __local int *sums) {
    // in a step that has stalled, these are the values of the detection before: they are still needed
    const int count = status[C2D_STALLED] != 0u ? 0 : all;
    const int first = min((int)get_global_id(0) * C2D_SCAN, count);
    const int sum = c2d_scan_part(values, first, min(first + C2D_SCAN, count), sums);
    if (get_local_id(0) == get_local_size(0) - 1) {
        partSums[get_group_id(0)] = sum;
    }
}

// Also the one place that stalls a detection.
__kernel void c2d_scan_sums(__global int *partSums, int parts, __global uint *status, uint capacity,
                            __local int *sums) {
    const int items = (int)get_local_size(0);
    const int part = (parts + items - 1) / items;
    const int first = min((int)get_local_id(0) * part, parts);
    c2d_scan_part(partSums, first, min(first + part, parts), sums);
    if (get_local_id(0) == 0 && status[C2D_CONTACTS] > capacity) {
        status[C2D_STALLED] = 1u;
    }
}

__kernel void c2d_scan_add(__global int *values, int count, __global const int *partSums,
                           __global const uint *status, int perPart) {
    const int k = (int)get_global_id(0);
    if (k >= perPart && k < count && status[C2D_STALLED] == 0u) {
        values[k] += partSums[k / perPart - 1];
    }
}
