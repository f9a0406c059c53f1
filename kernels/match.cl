// Sorts the contacts by owner and numbers, and gives each what the detection before remembers of it. One work-item a contact,
// going round where contacts are more. Twin of host.Match.

// Takes the last free place of the owner, which leaves ownerStart at the first.
__kernel void c2d_match_scatter(__global const int4 *found, __global const int *foundOwner, __global int *ownerStart,
                                __global const uint *status, __global int4 *byOwner, __global int *ownerOf) {
    const uint contacts = status[C2D_STALLED] != 0u ? 0u : status[C2D_CONTACTS];
    for (uint k = (uint)get_global_id(0); k < contacts; k += (uint)get_global_size(0)) {
        const int owner = foundOwner[k];
        const int place = atomic_dec(&ownerStart[owner]) - 1;
        byOwner[place] = found[k];
        ownerOf[place] = owner;
    }
}

static bool c2d_before(int2 a, int2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

// The contact of two circles at the detection before, or -1: its owner follows from their cells, its place from a search.
static int c2d_remembered(int2 ids, __global const int4 *cellBefore, __global const int8 *levelsBefore,
                          __global const int *ownerStartBefore, __global const int2 *idsBefore) {
    const int4 a = cellBefore[ids.x];
    const int4 b = cellBefore[ids.y];
    if (a.z < 0 || b.z < 0) {
        return -1;
    }
    const int8 level = levelsBefore[max(a.z, b.z)];
    const int owner = c2d_owner_of_two(level, a.xy >> level.C2D_SHIFT, b.xy >> level.C2D_SHIFT);
    if (owner < 0) {
        return -1;
    }
    int low = ownerStartBefore[owner];
    const int end = ownerStartBefore[owner + 1];
    int high = end;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (c2d_before(idsBefore[middle], ids)) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low < end && idsBefore[low].x == ids.x && idsBefore[low].y == ids.y ? low : -1;
}

__kernel void c2d_match(__global const int4 *byOwner, __global const int *ownerOf, __global const int *ownerStart,
                        __global uint *status, __global const int4 *cellBefore, __global const int8 *levelsBefore,
                        __global const int *ownerStartBefore, __global const int2 *idsBefore,
                        __global const float2 *memoryBefore, __global int2 *pair, __global int2 *ids,
                        __global float2 *memory) {
    if (status[C2D_STALLED] != 0u) {
        return;
    }
    if (get_global_id(0) == 0) {
        status[C2D_UPDATES] += 1u;
    }
    const uint contacts = status[C2D_CONTACTS];
    for (uint k = (uint)get_global_id(0); k < contacts; k += (uint)get_global_size(0)) {
        const int4 own = byOwner[k];
        const int start = ownerStart[ownerOf[k]];
        const int end = ownerStart[ownerOf[k] + 1];
        int place = start;
        for (int other = start; other < end; other++) {
            // word by word: Oclgrind goes wrong where this loop is vectorised over shuffled int4s
            const int a = ((__global const int *)byOwner)[4 * other + 2];
            const int b = ((__global const int *)byOwner)[4 * other + 3];
            place += a < own.z || (a == own.z && b < own.w) ? 1 : 0;
        }
        const int old = c2d_remembered(own.zw, cellBefore, levelsBefore, ownerStartBefore, idsBefore);
        pair[place] = own.xy;
        ids[place] = own.zw;
        memory[place] = old < 0 ? (float2)(0.0f, 0.0f) : memoryBefore[old];
    }
}
