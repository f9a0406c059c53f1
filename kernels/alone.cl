// Worlds so small that launches take longer than what they do: stages of several launches, and all substeps of a detection, by one
// work-group. What is done is that of the other files, in an order that comes to the same: all tiles of a tiling are one tile
// here, for their contacts share no circle. On the host it is what host.Grid, host.Batch and host.Solve do.

// grid.cl.
__kernel void c2d_alone_grid(__global const float8 *bodyBefore, __global const int *idBefore,
                             __global const int8 *levels, __global const float *rule, __global uint *status,
                             int allCircles, int allCells, int parts, __global int *bucketStart, __global int *tileStart,
                             __global int *bucket, __global int *unsorted, __global float8 *body, __global int *id,
                             __global int *from, __global int *listStart, __local int *sums) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const bool stalled = status[C2D_STALLED] != 0u;
    const int circles = stalled ? 0 : allCircles;
    const int cells = stalled ? -1 : allCells;
    for (int k = item; k <= max(cells, stalled ? -1 : parts); k += items) {
        c2d_grid_clear_at(k, bucketStart, tileStart, status, cells, parts);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (int i = item; i < circles; i += items) {
        c2d_grid_bin_at(i, bodyBefore, levels, rule, circles, bucket, bucketStart);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    c2d_scan_group(bucketStart, cells + 1, sums);
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (int i = item; i < circles; i += items) {
        c2d_grid_scatter_at(i, bucket, bucketStart, circles, unsorted);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (int p = item; p < circles; p += items) {
        c2d_grid_order_at(p, unsorted, bucket, bucketStart, bodyBefore, idBefore, circles, body, id, from, listStart);
    }
}

// batch.cl. `tiles`: the tilings.
__kernel void c2d_alone_batch(C2D_BATCH_COLOUR, __global const float8 *body, __global const int8 *tilings,
                              __global const float *rule, int circles, int tiles,
                              __global int *tileStart, __global int *byTile, __global int2 *pairs,
                              __global int *tileColours, __local int *sums) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const int8 all = levels[0];
    const bool stalled = status[C2D_STALLED] != 0u;
    const int contacts = stalled ? 0 : listStart[circles];
    for (int k = item; k < contacts; k += items) {
        c2d_batch_count_at(k, true, body, all, tilings, rule, other, capacity, batch, tileStart);
    }
    for (int p = item; p < (stalled ? 0 : circles); p += items) {
        beyond[p] = 0;
        mask[p] = 0ul;
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    c2d_scan_group(tileStart, stalled ? 0 : C2D_PARTS * tiles + 1, sums);
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (int k = item; k < contacts; k += items) {
        c2d_batch_fill_at(k, capacity, batch, tileStart, byTile);
    }
    c2d_batch_colour_levels(C2D_BATCH_COLOUR_HERE, 0, all.C2D_LEVELS, stalled);
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (int tile = 0; tile < tiles; tile++) {
        c2d_batch_order_tile(tile, other, byTile, tint, capacity, batch, pairs, tileStart, tileColours, stalled, false,
                             beyond, sums);
    }
}

// All substeps of a detection: integrate.cl and solve.cl.
__kernel void c2d_alone_solve(C2D_SOLVE, int circles, int tiles, int substeps) {
    const int count = status[C2D_STALLED] != 0u ? 0 : circles;
    for (int substep = 0; substep < substeps; substep++) {
        for (int i = (int)get_local_id(0); i < count; i += (int)get_local_size(0)) {
            body[i] = c2d_integrated(i, substep > 0, true, body, id, kicked, walls, rule);
        }
        barrier(CLK_GLOBAL_MEM_FENCE);
        for (int tile = 0; tile < tiles; tile++) {
            c2d_solve_tile(tile, C2D_SOLVE_HERE);
        }
    }
}
