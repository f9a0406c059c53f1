// Parts the circles that overlap and exchanges their impulses: Solver.IMPULSE (thesis, chapter 4, kernels 5 to 7), in
// the order that colour made. One work-item an owner cell.

// A centre moved by a translation stays within the walls.
static float c2d_within(float position, float lo, float hi) {
    const float low = position < lo ? lo : position;
    return low > hi ? hi : low;
}

// Twin of host.Resolve.contact, where the rule is explained.
static void c2d_resolve_contact(int4 pair, __global float4 *circle, __global float2 *velocities, float4 bounds,
                                float restitution) {
    const float2 translation = c2d_translation_of(pair);
    const float4 a = circle[pair.x];
    const float4 b = circle[pair.y];
    const float inverseA = 1.0f / a.w;
    const float inverseB = 1.0f / b.w;
    const float inverseSum = inverseA + inverseB;
    const float shareA = inverseA / inverseSum;
    const float shareB = inverseB / inverseSum;
    circle[pair.x].xy = (float2)(c2d_within(a.x - translation.x * shareA, bounds.x + a.z, bounds.z - a.z),
                                 c2d_within(a.y - translation.y * shareA, bounds.y + a.z, bounds.w - a.z));
    circle[pair.y].xy = (float2)(c2d_within(b.x + translation.x * shareB, bounds.x + b.z, bounds.z - b.z),
                                 c2d_within(b.y + translation.y * shareB, bounds.y + b.z, bounds.w - b.z));

    const float depth = sqrt(translation.x * translation.x + translation.y * translation.y);
    const float nx = translation.x / depth;
    const float ny = translation.y / depth;
    const float2 va = velocities[pair.x];
    const float2 vb = velocities[pair.y];
    const float approach = (va.x - vb.x) * nx + (va.y - vb.y) * ny;
    if (approach > 0.0f) {
        const float impulse = -(1.0f + restitution) * approach / inverseSum;
        const float gainA = impulse * inverseA;
        const float gainB = impulse * inverseB;
        velocities[pair.x] = (float2)(va.x + gainA * nx, va.y + gainA * ny);
        velocities[pair.y] = (float2)(vb.x - gainB * nx, vb.y - gainB * ny);
    }
}

// Owner cell number `item` of a colour, or -1 past the last one. Twin of pipeline.CellGrid.owner.
static int c2d_owner_of(int item, int colour, int columns, int rows) {
    const int x0 = colour % 3;
    const int y0 = colour / 3;
    const int across = (columns - x0 + 2) / 3;
    const int up = (rows - y0 + 1) / 2;
    if (across <= 0 || item >= across * up) {
        return -1;
    }
    const int line = item / across;
    return (y0 + 2 * line) * columns + x0 + 3 * (item - line * across);
}

static void c2d_resolve_cell(int cell, __global float4 *circle, __global float2 *velocities,
                             __global const int4 *contact, __global const int *cellStart, uint contacts, int columns,
                             int rows, float4 bounds, float restitution) {
    const int end = c2d_cell_end(cell, columns, rows, cellStart, contacts);
    for (int k = cellStart[cell]; k < end; k++) {
        c2d_resolve_contact(contact[k], circle, velocities, bounds, restitution);
    }
}

// A large world: one launch a colour.
__kernel void c2d_resolve(__global float4 *circle, __global float2 *velocities, __global const int4 *contact,
                          __global const int *cellStart, __global const uint *status, float4 bounds,
                          float restitution, int columns, int rows, int colour) {
    const int cell = c2d_owner_of((int)get_global_id(0), colour, columns, rows);
    if (cell >= 0 && status[C2D_STALLED] == 0u) {
        c2d_resolve_cell(cell, circle, velocities, contact, cellStart, status[C2D_CONTACTS], columns, rows, bounds,
                         restitution);
    }
}

// A small world: colour and resolve in one launch of one work-group. Launches would cost more than the work.
__kernel void c2d_resolve_small(__global float4 *circle, float2 corner, float perUnit, int columns, int rows,
                                __global const int4 *found, __global int *cellStart, __global int4 *byCell,
                                __global int4 *contact, __global float2 *velocities, __global uint *status,
                                uint capacity, float4 bounds, float restitution, __local int *sums) {
    const uint item = (uint)get_local_id(0);
    const uint items = (uint)get_local_size(0);
    const uint contacts = status[C2D_CONTACTS];
    if (contacts > capacity) {
        if (item == 0) {
            status[C2D_STALLED] = 1u;
        }
        return;
    }
    for (uint k = item; k < contacts; k += items) {
        c2d_count(k, circle, corner, perUnit, columns, rows, found, cellStart);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    c2d_scan(cellStart, columns * rows, sums);
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (uint k = item; k < contacts; k += items) {
        c2d_scatter(k, circle, corner, perUnit, columns, rows, found, cellStart, byCell);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (uint k = item; k < contacts; k += items) {
        c2d_rank(k, circle, corner, perUnit, columns, rows, byCell, cellStart, contacts, contact);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (int colour = 0; colour < 6; colour++) {
        int cell;
        for (int c = (int)item; (cell = c2d_owner_of(c, colour, columns, rows)) >= 0; c += (int)items) {
            c2d_resolve_cell(cell, circle, velocities, contact, cellStart, contacts, columns, rows, bounds,
                             restitution);
        }
        barrier(CLK_GLOBAL_MEM_FENCE);
    }
}
