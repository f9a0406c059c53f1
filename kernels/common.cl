// Comes before every other kernel file: types, the layout of the status buffer, arithmetic that stages share.
//
// Bits: state is computed with + - * / sqrt and comparisons alone, uncontracted, so that every device and the plain
// Java twin of each kernel (package host) end in the same bits.
#pragma OPENCL FP_CONTRACT OFF

// 1: pair indices need 64 bits (65,537 circles and more). The host sets it from the number of circles.
#ifndef C2D_WIDE
#define C2D_WIDE 0
#endif

// 1: detect fills the thesis' triangle of translation vectors; 0: it lists the contacts alone.
#ifndef C2D_TRIANGLE
#define C2D_TRIANGLE 0
#endif

// 1: the index strategy numbers the pairs; 0: circles look for neighbours in a grid.
#ifndef C2D_PAIRWISE
#define C2D_PAIRWISE 1
#endif

// Index of a pair in the triangle, and the pair of bounds that a row of it takes.
#if C2D_WIDE
typedef ulong c2d_index;
typedef ulong2 c2d_row;
#else
typedef uint c2d_index;
typedef uint2 c2d_row;
#endif

// 1: memory is far, as on a GPU, and is read ahead; 0: there are caches that do so.
#ifndef C2D_GPU
#define C2D_GPU 0
#endif

// Pairs that a work-item of detect looks at.
#ifndef C2D_PAIRS
#define C2D_PAIRS 1
#endif

// Values that a work-item scans at a time, a multiple of four.
#ifndef C2D_SCAN
#define C2D_SCAN 8
#endif

// Pairs of the triangle that share a mark.
#ifndef C2D_BLOCK
#define C2D_BLOCK 256
#endif

// The status buffer, class pipeline.Status: how many contacts the step found, whether they outgrew their buffers (then
// nothing moves until the host has made room), how many updates have run. Of small steps: how many detections, how many tiles of one
// tiling have anything in them, and, as bits, how the circles move at the end of a step, class pipeline.Motion: the highest speed in
// radii a second, the squares of the farthest that one has come and of the highest speed in world units a second, and the highest
// speeds to the right, left, up and down. Then how far circles may have come since contacts were listed, before that step.
#define C2D_CONTACTS 0
#define C2D_STALLED 1
#define C2D_UPDATES 2
#define C2D_TILES 3
#define C2D_MOTION 4
#define C2D_MOTIONS 7
#define C2D_MOVED_SQUARE (C2D_MOTION + 1)
#define C2D_GONE (C2D_MOTION + C2D_MOTIONS)
// What stalled says where contacts are so dense that no order of colours holds them.
#define C2D_TOO_DENSE 2u

// A contact as detect finds it is an int4: the numbers i < j of its circles, and the bits of the translation vector from i
// to j.
// Appends a contact; one that finds the buffer full is counted all the same, so that the host knows what is needed.
static void c2d_append(int2 pair, float2 translation, __global int4 *found, __global uint *status, uint capacity) {
#if C2D_WIDE
    // so many circles can meet in more pairs than the counter holds; it stays where it says "too many"
    if (atomic_add(&status[C2D_CONTACTS], 0u) > (uint)INT_MAX) {
        return;
    }
#endif
    const uint slot = atomic_inc(&status[C2D_CONTACTS]);
    if (slot < capacity) {
        found[slot] = (int4)(pair.x, pair.y, as_int(translation.x), as_int(translation.y));
    }
}

// Reads and writes the values from `first` on that a work-item scans, by fours where it has all of them.
static void c2d_scan_read(__global const int *values, int first, int count, int *own) {
    if (first + C2D_SCAN <= count) {
        for (int k = 0; k < C2D_SCAN; k += 4) {
            const int4 four = *(__global const int4 *)(values + first + k);
            own[k] = four.x;
            own[k + 1] = four.y;
            own[k + 2] = four.z;
            own[k + 3] = four.w;
        }
    } else {
        for (int k = 0; k < C2D_SCAN; k++) {
            own[k] = first + k < count ? values[first + k] : 0;
        }
    }
}

static void c2d_scan_write(__global int *values, int first, int count, const int *own) {
    if (first + C2D_SCAN <= count) {
        for (int k = 0; k < C2D_SCAN; k += 4) {
            *(__global int4 *)(values + first + k) = (int4)(own[k], own[k + 1], own[k + 2], own[k + 3]);
        }
    } else {
        for (int k = 0; k < C2D_SCAN; k++) {
            if (first + k < count) {
                values[first + k] = own[k];
            }
        }
    }
}

// Turns counts into sums, each the sum of all up to it and of `before`; sums too large for an int stay the largest int. Every
// work-item of a group has C2D_SCAN of the values, from `first` on. Returns the sum up to the last of its own.
static int c2d_scan_part(__global int *values, int first, int count, int before, __local int *sums) {
    const int item = (int)get_local_id(0);
    int own[C2D_SCAN];
    c2d_scan_read(values, first, count, own);
    int sum = 0;
    for (int k = 0; k < C2D_SCAN; k++) {
        sum = add_sat(sum, own[k]);
    }
    sums[item] = sum;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int step = 1; step < (int)get_local_size(0); step *= 2) {
        const int lower = item >= step ? sums[item - step] : 0;
        barrier(CLK_LOCAL_MEM_FENCE);
        sums[item] = add_sat(sums[item], lower);
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    sum = item > 0 ? add_sat(before, sums[item - 1]) : before;
    for (int k = 0; k < C2D_SCAN; k++) {
        sum = add_sat(sum, own[k]);
        own[k] = sum;
    }
    c2d_scan_write(values, first, count, own);
    return sum;
}

// The same for all of the values, by one group: as many as it can at a time. Returns the sum of all. What comes before is read
// back: PoCL 3.0 cannot compile a sum that lives on from barrier to barrier.
static int c2d_scan_group(__global int *values, int count, __local int *sums) {
    const int items = (int)get_local_size(0);
    for (int from = 0; from < count; from += C2D_SCAN * items) {
        const int first = from + C2D_SCAN * (int)get_local_id(0);
        c2d_scan_part(values, first, count, from > 0 ? values[from - 1] : 0, sums);
        barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    }
    return count > 0 ? values[count - 1] : 0;
}
