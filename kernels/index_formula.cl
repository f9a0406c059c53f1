// Strategy 0 of the thesis: the pair from its index by a square root, here followed by an exact correction.
// Pairs are counted from the last one, where rows grow by one: row r holds k = r(r+1)/2 .. r(r+1)/2 + r.

static c2d_index c2d_triangular(c2d_index r) { return r * (r + 1) / 2; }

static int2 c2d_pair_at(c2d_index pair, c2d_index first, int circles, __global const int2 *table) {
    const c2d_index n = (c2d_index)circles;
    const c2d_index k = n * (n - 1) / 2 - 1 - pair;
    c2d_index r = (c2d_index)((sqrt(8.0f * (float)k + 1.0f) - 1.0f) * 0.5f);
#if C2D_WIDE
    // the root of a 64-bit number is some hundred rows off; one Newton step on the exact remainder leaves one row
    const long rest = (long)k - (long)c2d_triangular(r);
    r += (c2d_index)(long)floor((float)rest / ((float)r + 0.5f)); // cut towards zero it could leave two
#endif
    r = c2d_triangular(r) > k ? r - 1 : r;
    r = c2d_triangular(r + 1) <= k ? r + 1 : r;
    return (int2)((int)(n - 2 - r), (int)(n - 1 - (k - c2d_triangular(r))));
}
