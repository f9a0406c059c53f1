// Strategy 1 of the thesis: one look-up in a table of all pairs, the thesis' buffer "indexes". Two halves of an int a pair, where
// the numbers of the circles fit: what a look-up takes is the way to the table.

static int2 c2d_pair_at(c2d_index pair, c2d_index first, int circles, __global const int2 *table) {
#if C2D_WIDE
    if (circles > 65536) {
        return table[pair - first];
    }
#endif
    return convert_int2(((__global const ushort2 *)table)[pair - first]);
}
