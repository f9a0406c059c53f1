// Sorts the circles by bucket of their cell, and by number within each: a counting sort, then ranks. One work-item a circle.
// Reads what the detection before wrote and leaves it as it is, so that a detection can be done again. Twin of host.Grid.

// Empties what is counted into, cell k and part k of the tiles, of as many and one more; and what the status says of contacts.
static void c2d_grid_clear_at(int k, __global int *bucketStart, __global int *tileStart, __global uint *status, int cells,
                              int parts) {
    if (k <= cells) {
        bucketStart[k] = 0;
    }
    if (k <= parts) {
        tileStart[k] = 0;
    }
    if (k == 0) {
        status[C2D_CONTACTS] = 0u;
    }
}

// By place at the detection before: the bucket of a circle, and then the turn of each in its bucket.
#define C2D_BUCKET C2D_AT(int, kicked)
// The circles by bucket, in no order.
#define C2D_UNSORTED C2D_AT(int, other)
#define C2D_BODY_BEFORE C2D_AT(float8, bodyBefore)
#define C2D_ID_BEFORE C2D_AT(const int, idBefore)

// The first launch of a detection.
__kernel void c2d_grid_clear(C2D_WORLD, int cells, int parts) {
    const int k = (int)get_global_id(0);
    if (status[C2D_STALLED] == 0u) {
        c2d_grid_clear_at(k, C2D_BUCKET_START, C2D_TILE_START, status, cells, parts);
        if (C2D_GPU && k < C2D_TILINGS) {
            C2D_LIVE[k] = 0;
        }
    }
}

// Counts the circles of each bucket, one place up, so that the sums of the counts are where buckets begin.
static void c2d_grid_bin_at(int i, __global const float8 *bodyBefore, __global const int8 *levels,
                            const c2d_numbers numbers, int circles, __global int *bucket, __global int *bucketStart) {
    const int4 cell = c2d_cell(bodyBefore[i], levels, numbers);
    const int8 level = levels[1 + cell.z];
    const int own = c2d_bucket(level, cell.x >> level.C2D_SHIFT, cell.y >> level.C2D_SHIFT);
    bucket[i] = own;
    bucket[circles + i] = atomic_inc(&bucketStart[own + 1]);
}

__kernel void c2d_grid_bin(C2D_WORLD) {
    const int i = (int)get_global_id(0);
    if (i < world.circles && status[C2D_STALLED] == 0u) {
        c2d_grid_bin_at(i, C2D_BODY_BEFORE, C2D_LEVEL_TABLE, world.numbers, world.circles, C2D_BUCKET, C2D_BUCKET_START);
    }
}

static void c2d_grid_scatter_at(int i, __global const int *bucket, __global const int *bucketStart, int circles,
                                __global int *unsorted) {
    unsorted[bucketStart[bucket[i]] + bucket[circles + i]] = i;
}

__kernel void c2d_grid_scatter(C2D_WORLD) {
    const int i = (int)get_global_id(0);
    if (i < world.circles && status[C2D_STALLED] == 0u) {
        c2d_grid_scatter_at(i, C2D_BUCKET, C2D_BUCKET_START, world.circles, C2D_UNSORTED);
    }
}

// Also empties the lists; turns are no longer needed, so that they can count how far a list is filled.
static void c2d_grid_order_at(int p, __global const int *unsorted, __global int *bucket,
                              __global const int *bucketStart, __global const float8 *bodyBefore,
                              __global const int *idBefore, int circles, __global float8 *body, __global int *id,
                              __global int *from, __global int *listStart) {
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
    from[place] = i;
    bucket[circles + p] = 0;
    listStart[p + 1] = 0;
    if (p == 0) {
        listStart[0] = 0;
    }
}

__kernel void c2d_grid_order(C2D_WORLD) {
    const int p = (int)get_global_id(0);
    if (p < world.circles && status[C2D_STALLED] == 0u) {
        c2d_grid_order_at(p, C2D_UNSORTED, C2D_BUCKET, C2D_BUCKET_START, C2D_BODY_BEFORE, C2D_ID_BEFORE, world.circles,
                          C2D_BODY, C2D_ID, C2D_FROM, C2D_LIST_START);
    }
}
