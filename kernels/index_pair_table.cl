// Strategy 1 of the thesis: one look-up in a table of all pairs, the thesis' buffer "indexes".

static int2 c2d_pair_at(c2d_index pair, c2d_index first, int circles, __global const int2 *table) {
    return table[pair - first];
}
