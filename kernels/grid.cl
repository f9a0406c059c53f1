// Sorts the circles by bucket of their cell, and by number within each: a counting sort, then ranks. One work-item a circle.
// Nothing moves between this and find, so that a detection can be done again. Twin of host.Grid.

// The first launch of a detection: empties what is counted into. `cells` + 1 work-items.
__kernel void c2d_grid_clear(__global int *bucketStart, __global int *ownerStart, __global uint *status, int cells) {
    const int k = (int)get_global_id(0);
    if (k > cells || status[C2D_STALLED] != 0u) {
        return;
    }
    bucketStart[k] = 0;
    ownerStart[k] = 0;
    if (k == 0) {
        status[C2D_CONTACTS] = 0u;
        status[C2D_FASTEST] = 0u;
    }
}

// Counts the circles of each bucket. `before`: in the order of the last detection.
__kernel void c2d_grid_bin(__global const float8 *bodyBefore, __global const int *idBefore, __global const int *levelOf,
                           __global const int8 *levels, __global int4 *cell, __global int *bucket,
                           __global int *bucketStart, __global const uint *status, __global const float *rule,
                           int circles, float perUnit, int lastColumn, int lastRow) {
    const int i = (int)get_global_id(0);
    if (i >= circles || status[C2D_STALLED] != 0u) {
        return;
    }
    const int id = idBefore[i];
    const float8 body = bodyBefore[i];
    const int number = levelOf[id];
    const int8 level = levels[number];
    const int2 finest = (int2)(c2d_finest(body.s0, C2D_MIN(0), perUnit, lastColumn),
                               c2d_finest(body.s1, C2D_MIN(1), perUnit, lastRow));
    const int own = c2d_bucket(level, finest >> level.C2D_SHIFT);
    cell[id] = (int4)(finest.x, finest.y, number, 0);
    bucket[i] = own;
    atomic_inc(&bucketStart[own]);
}

// Takes the last free place of the bucket, which leaves bucketStart at the first.
__kernel void c2d_grid_scatter(__global const int *bucket, __global int *bucketStart, __global const uint *status,
                               int circles, __global int *unsorted) {
    const int i = (int)get_global_id(0);
    if (i < circles && status[C2D_STALLED] == 0u) {
        unsorted[atomic_dec(&bucketStart[bucket[i]]) - 1] = i;
    }
}

__kernel void c2d_grid_order(__global const int *unsorted, __global const int *bucket, __global const int *bucketStart,
                             __global const float8 *bodyBefore, __global const int *idBefore,
                             __global const uint *status, int circles, __global float8 *body, __global int *id) {
    const int p = (int)get_global_id(0);
    if (p >= circles || status[C2D_STALLED] != 0u) {
        return;
    }
    const int i = unsorted[p];
    const int own = idBefore[i];
    const int start = bucketStart[bucket[i]];
    const int end = bucketStart[bucket[i] + 1];
    int place = start;
    for (int other = start; other < end; other++) {
        place += idBefore[unsorted[other]] < own ? 1 : 0;
    }
    body[place] = bodyBefore[i];
    id[place] = own;
}
