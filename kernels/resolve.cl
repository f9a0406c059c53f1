// Parts the circles that overlap and exchanges their impulses, in the order that colour made; the rule is in contact.cl.
// One work-item an owner cell.

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
                             __global const int8 *contact, __global const int *cellStart, uint contacts, int columns,
                             int rows, float4 bounds) {
    const int end = c2d_cell_end(cell, columns, rows, cellStart, contacts);
    for (int k = cellStart[cell]; k < end; k++) {
        c2d_resolve_contact(contact[k], circle, velocities, bounds);
    }
}

// A large world: one launch a colour.
__kernel void c2d_resolve(__global float4 *circle, __global float2 *velocities, __global const int8 *contact,
                          __global const int *cellStart, __global const uint *status, float4 bounds,
                          int columns, int rows, int colour) {
    const int cell = c2d_owner_of((int)get_global_id(0), colour, columns, rows);
    if (cell >= 0 && status[C2D_STALLED] == 0u) {
        c2d_resolve_cell(cell, circle, velocities, contact, cellStart, status[C2D_CONTACTS], columns, rows, bounds);
    }
}

// A small world: colour and resolve in one launch of one work-group. Launches would cost more than the work.
__kernel void c2d_resolve_small(__global float4 *circle, float2 corner, float perUnit, int columns, int rows,
                                __global const int4 *found, __global int *cellStart, __global int4 *byCell,
                                __global int8 *contact, __global float2 *velocities, __global uint *status,
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
    c2d_scan_group(cellStart, columns * rows, sums);
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (uint k = item; k < contacts; k += items) {
        c2d_scatter(k, circle, corner, perUnit, columns, rows, found, cellStart, byCell);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (uint k = item; k < contacts; k += items) {
        c2d_rank(k, circle, corner, perUnit, columns, rows, byCell, cellStart, contacts, restitution,
                 contact);
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (int colour = 0; colour < 6; colour++) {
        int cell;
        for (int c = (int)item; (cell = c2d_owner_of(c, colour, columns, rows)) >= 0; c += (int)items) {
            c2d_resolve_cell(cell, circle, velocities, contact, cellStart, contacts, columns, rows, bounds);
        }
        barrier(CLK_GLOBAL_MEM_FENCE);
    }
}
