// Strategy 2 of the thesis: a binary search in a table of the first and last pair of each row, the buffer "rows".

static int2 c2d_pair_at(c2d_index pair, c2d_index first, int circles, __global const int2 *table) {
    __global const c2d_row *rows = (__global const c2d_row *)table;
    int low = 0;
    int high = circles - 2;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (pair > rows[middle].y) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return (int2)(low, low + 1 + (int)(pair - rows[low].x));
}
