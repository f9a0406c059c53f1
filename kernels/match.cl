// Gives each contact what the detection before remembers of it. One work-item a contact, going round where contacts are more.
// Twin of host.Match.

// Orders what find put at the start of lists, whoever came first: those of smaller circles, or, of an index strategy, all.
__kernel void c2d_match_order(C2D_WORLD) {
    __global const int2 *found = C2D_FOUND;
    __global const int *filled = C2D_FILLED;
    __global const int *listStart = C2D_LIST_START;
    __global int *other = C2D_OTHER;
    const int circles = world.circles;
    const int contacts = status[C2D_STALLED] != 0u ? 0 : listStart[circles];
    for (int k = (int)get_global_id(0); k < contacts; k += (int)get_global_size(0)) {
        const int2 own = found[k];
        const int start = listStart[own.y];
        const int end = start + filled[circles + own.y];
        if (k < end) {
            int place = start;
            for (int at = start; at < end; at++) {
                // word by word: Oclgrind goes wrong where this loop is vectorised over shuffled int2s
                place += ((__global const int *)found)[2 * at] < own.x ? 1 : 0;
            }
            other[place] = own.x;
        }
    }
}

// Where circle j is in the list of circle i at the detection before, or -1.
static int c2d_remembered(int i, int j, __global const int *listStartBefore, __global const int *otherBefore) {
    int low = listStartBefore[i];
    const int end = listStartBefore[i + 1];
    int high = end;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (otherBefore[middle] < j) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low < end && otherBefore[low] == j ? low : -1;
}

// `found` holds what find has found of each contact, and then what is remembered of it; `batch` begins with the circle in
// whose list it is.
__kernel void c2d_match(C2D_WORLD) {
    __global const int *from = C2D_FROM;
    __global const int *listStart = C2D_LIST_START;
    __global const int *listStartBefore = C2D_AT(const int, listStartBefore);
    __global const int *otherBefore = C2D_AT(const int, otherBefore);
    __global int2 *found = C2D_FOUND;
    if (status[C2D_STALLED] != 0u) {
        return;
    }
    const int contacts = listStart[world.circles];
    if (get_global_id(0) == 0) {
        status[C2D_UPDATES] += 1u;
    }
    for (int k = (int)get_global_id(0); k < contacts; k += (int)get_global_size(0)) {
        const int lists = found[k].y;
        const int i = from[lists];
        const int j = from[C2D_OTHER[k]];
        int old = c2d_remembered(i, j, listStartBefore, otherBefore);
        if (old < 0) {
            old = c2d_remembered(j, i, listStartBefore, otherBefore);
        }
        found[k] = old < 0 ? (int2)(0, 0) : C2D_AT(const int2, memory)[C2D_WHERE[old]];
        C2D_BATCH[k] = lists;
    }
}
