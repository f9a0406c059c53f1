// The triangle folded into a rectangle: row p and row n - 1 - p (n - 2 - p where n is odd) together fill one line of
// the rectangle, so a pair costs one integer division. No table, no root.

static int2 c2d_pair_at(c2d_index pair, c2d_index first, int circles, __global const int2 *table) {
    const int odd = circles & 1;
    const c2d_index width = (c2d_index)(circles - 1 + odd);
    const c2d_index line = pair / width;
    const int p = (int)line;
    const int q = (int)(pair - line * width);
    return q < circles - 1 - p ? (int2)(p, p + 1 + q) : (int2)(circles - 1 - odd - p, q + 1 - odd);
}
