// Worlds so small that launches take longer than what they do: stages of several launches, and all substeps of a detection, by one
// work-group. Such a world is one tile. What is done is that of the other files; on the host it is what host.Grid, host.Batch and
// host.Solve do.

// grid.cl.
__kernel C2D_ONE void c2d_alone_grid(C2D_WORLD, int allCells, __local int *sums) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const bool stalled = status[C2D_STALLED] != 0u;
    const int circles = stalled ? 0 : world.circles;
    const int cells = stalled ? -1 : allCells;
    for (int k = item; k <= cells; k += items) {
        c2d_grid_clear_at(k, C2D_BUCKET_START, C2D_TILE_START, status, cells, C2D_PARTS);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (int i = item; i < circles; i += items) {
        c2d_grid_bin_at(i, C2D_BODY_BEFORE, C2D_LEVEL_TABLE, world.numbers, circles, C2D_BUCKET, C2D_BUCKET_START);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    c2d_scan_group(C2D_BUCKET_START, cells + 1, sums);
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (int i = item; i < circles; i += items) {
        c2d_grid_scatter_at(i, C2D_BUCKET, C2D_BUCKET_START, circles, C2D_UNSORTED);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (int p = item; p < circles; p += items) {
        c2d_grid_order_at(p, C2D_UNSORTED, C2D_BUCKET, C2D_BUCKET_START, C2D_BODY_BEFORE, C2D_ID_BEFORE, circles, C2D_BODY,
                          C2D_ID, C2D_FROM, C2D_LIST_START);
    }
}

// batch.cl. What comes after `counts` is for batch_local.cl and batch_place.cl.
__kernel C2D_ONE void c2d_alone_batch(C2D_WORLD, __local int *counts, int most, int slots, __local uint *masks,
                              __local int *places, __local int2 *entries, __local ushort *codes, __local ushort *starts,
                              __local int *bins, __local int *rows) {
    const bool direct = true;
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const bool stalled = status[C2D_STALLED] != 0u;
    const int contacts = stalled ? 0 : C2D_LIST_START[world.circles];
    // in one tile, and in one part of it, in the order of the lists
    for (int k = item; k < contacts; k += items) {
        C2D_BY_TILE[k] = k;
        C2D_CODE[k] = (ushort)c2d_batch_code(c2d_cell(C2D_BODY[C2D_BATCH[k]], C2D_LEVEL_TABLE, world.numbers), C2D_LEVEL_TABLE);
        C2D_BATCH[2 * world.capacity + k] = 0;
    }
    if (item == 0) {
        C2D_TILE_START[C2D_PARTS] = contacts;
    }
    for (int p = item; p < (stalled ? 0 : world.circles); p += items) {
        C2D_BEYOND[p] = 0;
        C2D_MASK[p] = 0ul;
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    c2d_batch_colour_tile(0, (int2)(0, 0), false, stalled, C2D_LOCAL_ALL, heap, status, world, C2D_SOLVES(0));
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    const bool placed = c2d_batch_placed(C2D_SOLVES(0), stalled, world.capacity, C2D_BATCH);
    c2d_batch_order_tile(0, C2D_OTHER, C2D_BY_TILE, world.capacity, C2D_BATCH, C2D_REMEMBERED, C2D_MEMORY, C2D_WHERE,
                         C2D_TILE_START, C2D_SOLVES(0), (int2)(0, 0), stalled, placed, true, 0, counts);
}

// What the end of some substeps `publishes`: nothing; that of a step, which has listed contacts or goes on with those that one before has.
#define C2D_NOTHING_YET 0
#define C2D_STEP 1
#define C2D_STEP_ON 2

// All substeps until the next detection, the end of the last included, or until the end of the step, which `publishes`: integrate.cl and
// solve.cl.
__kernel C2D_ONE void c2d_alone_solve(C2D_WORLD, int publishes, __global float4 *circle, __global float2 *velocities,
                              __local float8 *bodies, __local uint *most, int substeps) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const bool stalled = status[C2D_STALLED] != 0u;
    const int circles = stalled ? 0 : world.circles;
    const int8 tile = *C2D_SOLVES(0);
    if (item == 0 && publishes != C2D_NOTHING_YET) {
        c2d_publish_gone(status, publishes == C2D_STEP_ON);
    }
    for (int i = item; i < circles; i += items) {
        c2d_body_to(bodies, i, circles, C2D_BODY[i]);
    }
    for (int k = item; k < C2D_MOTIONS; k += items) {
        most[k] = 0u;
    }
    uint8 motion = (uint8)(0u);
    // the end of the last substep as one that only moves: what is inlined twice compiles twice
    for (int substep = 0; substep <= substeps; substep++) {
        const bool ends = substep == substeps;
        for (int i = item; i < circles; i += items) {
            const float8 body = c2d_integrated(c2d_body_of(bodies, i, circles), i, substep > 0, !ends, C2D_CIRCLES_HERE);
            if (ends) {
                C2D_BODY[i] = body;
            } else {
                c2d_body_to(bodies, i, circles, body);
            }
            if (ends && publishes) {
                motion = c2d_publish(body, C2D_ID[i], circle, velocities, motion);
            }
        }
        barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
        c2d_solve_bodies(tile.s0, tile.s1, stalled || ends ? 0 : tile.s4, bodies, circles, 0, C2D_SOLVE_HERE);
    }
    if (publishes) {
        c2d_publish_most(motion, most);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int k = item; k < C2D_MOTIONS && publishes; k += items) {
        status[C2D_MOTION + k] = most[k];
    }
}
