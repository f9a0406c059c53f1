// Finds the circles that overlap without numbering the pairs, IndexStrategy.grid(): circles are sorted by the cells that own
// contacts, and each looks into the cells around its own. One work-item a circle. Twin of host.Near. The order within a cell
// is that of who came first; colour leaves no trace of it.

__kernel void c2d_near_clear(__global int *nearStart, int cells) {
    if ((int)get_global_id(0) < cells) {
        nearStart[get_global_id(0)] = 0;
    }
}

static int c2d_near_cell(int i, C2D_CELLS) {
    const int2 cell = c2d_cell(circle[i].xy, corner, perUnit, columns, rows);
    return cell.y * columns + cell.x;
}

__kernel void c2d_near_count(C2D_CELLS, int circles, __global int *nearStart) {
    const int i = (int)get_global_id(0);
    if (i < circles) {
        atomic_inc(&nearStart[c2d_near_cell(i, circle, corner, perUnit, columns, rows)]);
    }
}

// After a scan: takes the last free place of the cell, which leaves nearStart at the first.
__kernel void c2d_near_scatter(C2D_CELLS, int circles, __global int *nearStart, __global const uint *status,
                               __global int *near) {
    const int i = (int)get_global_id(0);
    if (i < circles && status[C2D_STALLED] == 0u) {
        near[atomic_dec(&nearStart[c2d_near_cell(i, circle, corner, perUnit, columns, rows)]) - 1] = i;
    }
}

__kernel void c2d_near_find(C2D_CELLS, int circles, __global const int *nearStart, __global const int *near,
                            __global int4 *found, __global uint *status, uint capacity) {
    const int i = (int)get_global_id(0);
    if (i >= circles || status[C2D_STALLED] != 0u) {
        return;
    }
    const float4 own = circle[i];
    const int2 cell = c2d_cell(own.xy, corner, perUnit, columns, rows);
    for (int y = max(cell.y - 1, 0); y <= min(cell.y + 1, rows - 1); y++) {
        // the cells of a row lie side by side
        const int start = nearStart[y * columns + max(cell.x - 1, 0)];
        const int last = y * columns + min(cell.x + 1, columns - 1);
        const int end = c2d_cell_end(last, columns, rows, nearStart, (uint)circles);
        for (int k = start; k < end; k++) {
            const int j = near[k];
            if (i < j) {
                c2d_contact(own, circle[j], (int2)(i, j), found, status, capacity);
            }
        }
    }
}
