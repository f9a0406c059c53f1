// Of stage batch: what puts a tile's contacts and circles into local memory, where batch_local.cl colours them.

// Slots that are tried.
#define C2D_TRIES 32

// The slot of a circle, or -1.
static int c2d_batch_slot(int place, int slots, bool direct, __local int *places) {
    if (direct) {
        return place < slots ? place : -1;
    }
    // by the golden ratio, so that neighbours do not meet
    uint slot = ((uint)place * 2654435769u) >> 16;
#pragma unroll 1
    for (int tries = 0; tries < C2D_TRIES; tries++, slot++) {
        const int at = (int)(slot & (uint)(slots - 1));
        const int was = atomic_cmpxchg(&places[at], -1, place);
        if (was == -1 || was == place) {
            return at;
        }
    }
    return -1;
}

// Puts the numbers of a tile's contacts into `entries`, bin by bin, those of a bin in the order of the lists.
static void c2d_batch_sort(int count, __global const int *byTile, __global const ushort *code, __local int2 *entries,
                           __local ushort *codes, __local int *bins) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    __local int *start = bins + C2D_BINS;
    for (int bin = item; bin < C2D_BINS; bin += items) {
        bins[bin] = 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int e = item; e < count; e += items) {
        entries[e].y = atomic_inc(&bins[C2D_BIN(code[byTile[e]])]);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int bin = item; bin <= C2D_BINS; bin += items) {
        int sum = 0;
#pragma unroll 4
        for (int before = 0; before < bin; before++) {
            sum += bins[before];
        }
        start[bin] = sum;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int e = item; e < count; e += items) {
        const int k = byTile[e];
        const int to = start[C2D_BIN(code[k])] + entries[e].y;
        entries[to].x = k;
        codes[to] = code[k];
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int e = item; e < count; e += items) {
        const int bin = C2D_BIN(codes[e]);
        const int k = entries[e].x;
        int to = start[bin];
#pragma unroll 4
        for (int o = start[bin]; o < start[bin + 1]; o++) {
            to += entries[o].x < k ? 1 : 0;
        }
        entries[to].y = k;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
}
