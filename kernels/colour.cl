// Puts the step's contacts in an order that needs no locks.
//
// A contact belongs to the lower (y, then x) of the cells of its two circles. A cell is as wide as the largest circle, so the
// contacts of owner cell (x, y) touch circles of the cells x-1..x+1, y..y+1 alone: owners that agree in x mod 3 and in
// y mod 2 share no circle. Six colours, free of conflicts by construction (design after Bullet's spatial batches).
// Within a cell contacts are sorted by the numbers of their circles: the order of the list they came in is lost.

// The cells: low corner, cells a world unit, columns and rows. Twin of pipeline.CellGrid.
static int2 c2d_cell(float2 position, float2 corner, float perUnit, int columns, int rows) {
    const int x = (int)((position.x - corner.x) * perUnit);
    const int y = (int)((position.y - corner.y) * perUnit);
    return (int2)(clamp(x, 0, columns - 1), clamp(y, 0, rows - 1));
}

static int c2d_owner(float2 a, float2 b, float2 corner, float perUnit, int columns, int rows) {
    const int2 p = c2d_cell(a, corner, perUnit, columns, rows);
    const int2 q = c2d_cell(b, corner, perUnit, columns, rows);
    return min(p.y * columns + p.x, q.y * columns + q.x);
}

#if C2D_TRIANGLE
// The thesis' second walk over the triangle: one work-item a pair, which finds its circles again where they overlap.
__kernel void c2d_colour_collect(__global const float2 *collision, __global const int2 *table, __global uint *status,
                                 int circles, ulong first, ulong pairs, __global int2 *contactPair,
                                 __global float2 *contactTranslation, uint capacity) {
    const size_t item = get_global_id(0);
    if (item >= pairs || status[C2D_STALLED] != 0u) {
        return;
    }
    const float2 translation = collision[item];
    if (translation.x != 0.0f || translation.y != 0.0f) {
        const int2 pair = c2d_pair_at((c2d_index)first + (c2d_index)item, (c2d_index)first, circles, table);
        c2d_append(pair, translation, contactPair, contactTranslation, status, capacity);
    }
}
#endif

// Hangs contact k into the list of its owner cell.
static void c2d_link(int k, __global const float4 *circle, __global const int2 *contactPair, __global int *next,
                     __global int *head, float2 corner, float perUnit, int columns, int rows) {
    const int2 pair = contactPair[k];
    const int cell = c2d_owner(circle[pair.x].xy, circle[pair.y].xy, corner, perUnit, columns, rows);
    next[k] = atomic_xchg(&head[cell], k);
}

static bool c2d_before(int2 a, int2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

// Sorts a list of contacts by the numbers of their circles: merges runs of 1, 2, 4, ... Twin of host.Colour.sorted.
static int c2d_sorted(int head, __global const int2 *contactPair, __global int *next) {
    for (int run = 1;; run *= 2) {
        int rest = head;
        int tail = C2D_NONE;
        int merges = 0;
        while (rest != C2D_NONE) {
            merges++;
            int left = rest;
            int right = rest;
            int lefts = 0;
            while (lefts < run && right != C2D_NONE) {
                right = next[right];
                lefts++;
            }
            int rights = run;
            while (lefts > 0 || (rights > 0 && right != C2D_NONE)) {
                const bool fromRight = rights > 0 && right != C2D_NONE
                        && (lefts == 0 || c2d_before(contactPair[right], contactPair[left]));
                const int least = fromRight ? right : left;
                if (fromRight) {
                    right = next[right];
                    rights--;
                } else {
                    left = next[left];
                    lefts--;
                }
                if (tail == C2D_NONE) {
                    head = least;
                } else {
                    next[tail] = least;
                }
                tail = least;
            }
            rest = right;
        }
        if (tail != C2D_NONE) {
            next[tail] = C2D_NONE;
        }
        if (merges <= 1) {
            return head;
        }
    }
}

// One work-item a contact, as many rounds as the contacts need. The one place that stalls a step.
__kernel void c2d_colour_link(__global const float4 *circle, __global const int2 *contactPair, __global int *next,
                              __global int *head, __global uint *status, uint capacity, float2 corner, float perUnit,
                              int columns, int rows) {
    const uint contacts = status[C2D_CONTACTS];
    if (contacts > capacity) {
        if (get_global_id(0) == 0) {
            status[C2D_STALLED] = 1u;
        }
        return;
    }
    for (uint k = (uint)get_global_id(0); k < contacts; k += (uint)get_global_size(0)) {
        c2d_link((int)k, circle, contactPair, next, head, corner, perUnit, columns, rows);
    }
}

// One work-item a cell.
__kernel void c2d_colour_sort(__global const int2 *contactPair, __global int *next, __global int *head,
                              __global const uint *status, int cells) {
    const int cell = (int)get_global_id(0);
    if (cell < cells && status[C2D_STALLED] == 0u) {
        head[cell] = c2d_sorted(head[cell], contactPair, next);
    }
}
