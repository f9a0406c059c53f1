// Puts the step's contacts in an order that needs no locks.
//
// A contact belongs to the lower (y, then x) of the cells of its two circles. A cell is wider than the largest circle, so the
// contacts of owner cell (x, y) touch circles of the cells x-1..x+1, y..y+1 alone: owners that agree in x mod 3 and in
// y mod 2 share no circle. Six colours, free of conflicts by construction (design after Bullet's spatial batches).
// Contacts are sorted by owner cell, and within it by the numbers of their circles: a counting sort, then ranks. The order
// they were found in leaves no trace. Step 2, between those named below, is c2d_scan_group: it turns counts into the place one
// past the last contact of each cell.

// The cells: low corner, cells in one world unit, columns and rows. Twin of pipeline.CellGrid.
static int2 c2d_cell(float2 position, float2 corner, float perUnit, int columns, int rows) {
    const int x = (int)((position.x - corner.x) * perUnit);
    const int y = (int)((position.y - corner.y) * perUnit);
    return (int2)(clamp(x, 0, columns - 1), clamp(y, 0, rows - 1));
}

// What the stage knows of the cells, in the order in which the kernels take it.
#define C2D_CELLS __global const float4 *circle, float2 corner, float perUnit, int columns, int rows

static int c2d_owner(int4 contact, C2D_CELLS) {
    const int2 p = c2d_cell(circle[contact.x].xy, corner, perUnit, columns, rows);
    const int2 q = c2d_cell(circle[contact.y].xy, corner, perUnit, columns, rows);
    return min(p.y * columns + p.x, q.y * columns + q.x);
}

// Step 1, a contact: counts the contacts of each cell into cellStart.
static void c2d_count(uint k, C2D_CELLS, __global const int4 *found, __global int *cellStart) {
    atomic_inc(&cellStart[c2d_owner(found[k], circle, corner, perUnit, columns, rows)]);
}

// Step 3, a contact: takes the last free place of its cell, which leaves cellStart at the first.
static void c2d_scatter(uint k, C2D_CELLS, __global const int4 *found, __global int *cellStart,
                        __global int4 *byCell) {
    const int4 own = found[k];
    byCell[atomic_dec(&cellStart[c2d_owner(own, circle, corner, perUnit, columns, rows)]) - 1] = own;
}

// One past the last contact of a cell.
static int c2d_cell_end(int cell, int columns, int rows, __global const int *cellStart, uint contacts) {
    return cell + 1 < columns * rows ? cellStart[cell + 1] : (int)contacts;
}

// Step 4, a contact: sorts the contacts of a cell by the numbers of their circles, and makes them ready.
static void c2d_rank(uint k, C2D_CELLS, __global const int4 *byCell, __global const int *cellStart, uint contacts,
                     float restitution, __global int8 *contact) {
    const int4 own = byCell[k];
    const int cell = c2d_owner(own, circle, corner, perUnit, columns, rows);
    const int start = cellStart[cell];
    const int end = c2d_cell_end(cell, columns, rows, cellStart, contacts);
    int place = start;
    for (int other = start; other < end; other++) {
        const int2 one = byCell[other].xy;
        if (one.x < own.x || (one.x == own.x && one.y < own.y)) {
            place++;
        }
    }
    contact[place] = c2d_prepare(own, circle, restitution);
}

#if C2D_TRIANGLE
// The thesis' second walk over the triangle, which finds the circles of each collision again; only where detect has marked
// one. One work-item a block of C2D_BLOCK pairs.
__kernel void c2d_colour_collect(__global const float2 *collision, __global const uint *mark,
                                 __global const int2 *table, __global uint *status, int circles, ulong first,
                                 ulong pairs, __global int4 *found, uint capacity) {
    const ulong block = get_global_id(0) * (ulong)C2D_BLOCK;
    if (block >= pairs || status[C2D_STALLED] != 0u || mark[get_global_id(0)] != status[C2D_UPDATES]) {
        return;
    }
    const ulong end = min(block + (ulong)C2D_BLOCK, pairs);
    for (ulong item = block; item < end; item++) {
        const float2 translation = collision[item];
        if (translation.x != 0.0f || translation.y != 0.0f) {
            const int2 pair = c2d_pair_at((c2d_index)(first + item), (c2d_index)first, circles, table);
            c2d_append(pair, translation, found, status, capacity);
        }
    }
}
#endif

// In a large world each step is a launch. One work-item a contact, going round where contacts are more.

// Step 1, and the one place that stalls a step.
__kernel void c2d_colour_count(C2D_CELLS, __global const int4 *found, __global int *cellStart, __global uint *status,
                               uint capacity) {
    const uint contacts = status[C2D_CONTACTS];
    if (contacts > capacity) {
        if (get_global_id(0) == 0) {
            status[C2D_STALLED] = 1u;
        }
        return;
    }
    for (uint k = (uint)get_global_id(0); k < contacts; k += (uint)get_global_size(0)) {
        c2d_count(k, circle, corner, perUnit, columns, rows, found, cellStart);
    }
}

// Step 2. One work-group.
__kernel void c2d_colour_scan(__global int *cellStart, __global const uint *status, int cells, __local int *sums) {
    c2d_scan_group(cellStart, status[C2D_STALLED] != 0u ? 0 : cells, sums);
}

// Step 3.
__kernel void c2d_colour_scatter(C2D_CELLS, __global const int4 *found, __global int *cellStart,
                                 __global const uint *status, __global int4 *byCell) {
    const uint contacts = status[C2D_STALLED] != 0u ? 0u : status[C2D_CONTACTS];
    for (uint k = (uint)get_global_id(0); k < contacts; k += (uint)get_global_size(0)) {
        c2d_scatter(k, circle, corner, perUnit, columns, rows, found, cellStart, byCell);
    }
}

// Step 4.
__kernel void c2d_colour_rank(C2D_CELLS, __global const int4 *byCell, __global const int *cellStart,
                              __global const uint *status, float restitution, __global int8 *contact) {
    const uint contacts = status[C2D_STALLED] != 0u ? 0u : status[C2D_CONTACTS];
    for (uint k = (uint)get_global_id(0); k < contacts; k += (uint)get_global_size(0)) {
        c2d_rank(k, circle, corner, perUnit, columns, rows, byCell, cellStart, contacts, restitution, contact);
    }
}
