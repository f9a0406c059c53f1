// Turns counts into sums: each value becomes the sum of all up to it. Many values take two launches: parts, one a work-group; what
// comes before a part added to it, for which each group sums up the parts before its own. Few take one launch of one work-group.
// Integers alone, so that the size of a group leaves no trace.

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

__kernel C2D_ONE void c2d_scan_few(C2D_WORLD, uint values, int all, int isLists, __local int *sums) {
    const int count = status[C2D_STALLED] != 0u ? 0 : all;
    c2d_scan_check(c2d_scan_group(C2D_VALUES, count, sums), isLists, world.capacity, status);
}

// What the parts before `part` add up to, by all of a group.
static int c2d_scan_before(int part, __global const int *partSums, __local int *sums) {
    const int item = (int)get_local_id(0);
    int own = 0;
    for (int before = item; before < part; before += (int)get_local_size(0)) {
        own = add_sat(own, partSums[before]);
    }
    sums[item] = own;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int width = (int)get_local_size(0); width > 1; width = (width + 1) / 2) {
        if (item < width / 2) {
            sums[item] = add_sat(sums[item], sums[item + (width + 1) / 2]);
        }
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    return sums[0];
}

// Groups as for the parts. In a step that has stalled, these add up to nothing, so that values stay what they are.
__kernel void c2d_scan_add(C2D_WORLD, uint values, int count, int isLists, __local int *sums) {
    const int part = (int)get_group_id(0);
    const int before = c2d_scan_before(part, C2D_PART_SUMS, sums);
    const int first = (int)get_global_id(0) * C2D_SCAN;
    if (part > 0) {
        int own[C2D_SCAN];
        c2d_scan_read(C2D_VALUES, first, count, own);
        for (int k = 0; k < C2D_SCAN; k++) {
            own[k] = add_sat(own[k], before);
        }
        c2d_scan_write(C2D_VALUES, first, count, own);
    }
    if (part == (int)get_num_groups(0) - 1) {
        c2d_scan_check(add_sat(before, C2D_PART_SUMS[part]), isLists, world.capacity, status);
    }
}
