// A detection and the substeps that follow it in one launch, where circles are few and launches would take longer than what
// they do: as many work-groups as run at once stay from the beginning to the end and wait for each other between stages
// ("persistent threads"; Gupta, Stuart and Owens, 2012). The stages are those of the other files. Twin of the launches that
// opencl.OpenClSmallStages makes otherwise, to the bit.
//
// Work-groups that wait for others need these to run. So those that have begun when the first has looked for a while are in;
// whoever begins later goes at once (Sorensen, Donaldson, Batty, Gopalakrishnan and Rakamaric, 2016). How many are in leaves no trace.

#if C2D_PERSISTENT

// opencl.DeviceFence.
#define C2D_FENCE_OF_OPENCL 2
#define C2D_FENCE_OF_PTX 3

// What one work-group has written, others read behind it.
#if C2D_PERSISTENT == C2D_FENCE_OF_OPENCL
#define C2D_DEVICE_FENCE atomic_work_item_fence(CLK_GLOBAL_MEM_FENCE, memory_order_acq_rel, memory_scope_device)
#elif C2D_PERSISTENT == C2D_FENCE_OF_PTX
#define C2D_DEVICE_FENCE __asm__ volatile("membar.gl;" ::: "memory")
#else
// one group alone
#define C2D_DEVICE_FENCE mem_fence(CLK_GLOBAL_MEM_FENCE)
#endif

// `meeting`: the number of the launch, above C2D_MET bits, whether nobody gets in any more, and how many are in; and how often
// a work-group has come to a barrier.
#define C2D_MET 12
#define C2D_CLOSED (1u << (C2D_MET - 1))
// How often the first looks.
#define C2D_PATIENCE 4000

// This group's number, and how many are in: none for one that is too late.
static int2 c2d_join(__global volatile uint *meeting, uint launch, __local int *scratch) {
    if (get_local_id(0) == 0) {
        uint seen = meeting[0];
        uint wanted = 0u;
        bool in = false;
        while (!in) {
            const bool old = seen >> C2D_MET != launch;
            if (!old && (seen & C2D_CLOSED) != 0u) {
                break;
            }
            wanted = old ? launch << C2D_MET | 1u : seen + 1u;
            const uint found = atomic_cmpxchg(&meeting[0], seen, wanted);
            in = found == seen;
            seen = found;
        }
        const int own = (int)(wanted & (C2D_CLOSED - 1u)) - 1;
        if (in && own == 0) {
            meeting[1] = 0u;
            for (int look = 0; look < C2D_PATIENCE && (meeting[0] & (C2D_CLOSED - 1u)) < get_num_groups(0); look++) {
            }
            C2D_DEVICE_FENCE;
            atomic_or(&meeting[0], C2D_CLOSED);
        }
        while (in && (meeting[0] & C2D_CLOSED) == 0u) {
        }
        C2D_DEVICE_FENCE;
        scratch[0] = own;
        scratch[1] = in ? (int)(meeting[0] & (C2D_CLOSED - 1u)) : 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    const int2 place = (int2)(scratch[0], scratch[1]);
    barrier(CLK_LOCAL_MEM_FENCE);
    return place;
}

// Waits until all groups are here.
static void c2d_meet(__global volatile uint *meeting, uint *expected, int groups) {
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    *expected += (uint)groups;
    if (get_local_id(0) == 0 && groups > 0) {
        C2D_DEVICE_FENCE;
        atomic_inc(&meeting[1]);
        while (meeting[1] < *expected) {
        }
        C2D_DEVICE_FENCE;
    }
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
}

// Turns counts into sums by all groups: each sums up a share, then knows what comes before its own. `capacity`: see scan.cl.
static void c2d_scan_shares(__global int *values, int count, int capacity, __global int *partSums, __global uint *status,
                            int group, int groups, __global volatile uint *meeting, uint *expected, __local int *sums) {
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const int share = (count + groups - 1) / max(groups, 1);
    const int first = min(group * share, count);
    const int end = min(first + share, count);
    int own = 0;
    for (int k = first + item; k < end; k += items) {
        own = add_sat(own, values[k]);
    }
    sums[item] = own;
    c2d_scan_items(sums);
    if (item == 0 && groups > 0) {
        partSums[group] = sums[items - 1];
    }
    c2d_meet(meeting, expected, groups);
    own = 0;
    for (int g = item; g < group; g += items) {
        own = add_sat(own, partSums[g]);
    }
    sums[item] = own;
    c2d_scan_items(sums);
    const int before = sums[items - 1];
    barrier(CLK_LOCAL_MEM_FENCE);
    const int all = c2d_scan_group(values + first, end - first, before, sums);
    if (groups > 0 && group == groups - 1) {
        c2d_scan_check(all, capacity, status);
    }
    c2d_meet(meeting, expected, groups);
}

#define C2D_EACH(k, count) for (int k = me; k < (count); k += we)
#define C2D_MEET c2d_meet(meeting, &expected, groups)

// `how`: the number of the launch, whether a substep comes before, how many follow the detection, whether the step ends with
// these; time for which the lists must hold, and how far gravity can part two circles in it.
#define C2D_LAUNCH s0
#define C2D_MOVES s1
#define C2D_SUBSTEPS s2
#define C2D_LAST s3
#define C2D_HORIZON s4
#define C2D_FALL s5

// What buffers hold at first, and then: batch.cl.
__kernel void c2d_persistent(C2D_CIRCLES, __global float8 *bodyBefore, __global const int *idBefore,
                             __global const int8 *levels, __global const int8 *tilings, __global uint *status,
                             int allCircles, int allCells, int allParts, __global int *bucketStart, __global int *bucket,
                             __global int *from, __global int *listStart, __global int *other, __global int2 *memory,
                             __global const int *listStartBefore, __global const int *otherBefore,
                             __global const int2 *memoryBefore, int capacity, __global int *batch,
                             __global int *tileStart, __global int *tileColours, int tiles, int tilingCount,
                             __global int *members, __global int *byTile, __global int2 *pairs, __global ushort *tint,
                             __global ulong *mask, __global int *partSums, __global float4 *circle,
                             __global float2 *velocities, __global volatile uint *meeting, __local int *scratch,
                             int8 how) {
    const bool moves = how.C2D_MOVES != 0;
    const int substeps = how.C2D_SUBSTEPS;
    const float horizon = as_float(how.C2D_HORIZON);
    const float fall = as_float(how.C2D_FALL);
    // without a return between barriers, and without barriers of only some paths: PoCL makes a copy of all that follows of each
    const int2 place = c2d_join(meeting, (uint)how.C2D_LAUNCH, scratch);
    const int group = place.x;
    const int groups = place.y;
    uint expected = 0u;
    const int here = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    const int me = group * items + here;
    const int we = groups * items;
    const int8 all = levels[0];
    const bool stalled = groups == 0 || status[C2D_STALLED] != 0u;
    int circles = stalled ? 0 : allCircles;
    int cells = stalled ? 0 : allCells + 1;
    int parts = stalled ? 0 : allParts + 1;

    C2D_EACH(i, moves ? circles : 0) {
        c2d_integrate_circle(i, true, false, bodyBefore, idBefore, kicked, walls, rule);
    }
    C2D_EACH(k, max(cells, parts)) { c2d_grid_clear_at(k, bucketStart, tileStart, status, cells - 1, parts - 1); }
    C2D_MEET;
    C2D_EACH(i, circles) { c2d_grid_bin_at(i, bodyBefore, levels, rule, circles, bucket, bucketStart); }
    C2D_MEET;
    c2d_scan_shares(bucketStart, cells, -1, partSums, status, group, groups, meeting, &expected, scratch);
    C2D_EACH(i, circles) { c2d_grid_scatter_at(i, bucket, bucketStart, circles, other); }
    C2D_MEET;
    C2D_EACH(p, circles) {
        c2d_grid_order_at(p, other, bucket, bucketStart, bodyBefore, idBefore, circles, body, id, from, listStart);
    }
    C2D_MEET;
    C2D_EACH(i, circles) {
        const int count = c2d_find_around(i, body, levels, rule, status, circles, listStart, bucket, other, memory,
                                          bucketStart, horizon, fall, false);
        atomic_add(&listStart[i + 1], count);
    }
    C2D_MEET;
    c2d_scan_shares(listStart, stalled ? 0 : circles + 1, capacity, partSums, status, group, groups, meeting, &expected, scratch);
    const bool full = stalled || status[C2D_STALLED] != 0u;
    const int contacts = full ? 0 : listStart[circles];
    circles = full ? 0 : circles;
    parts = full ? 0 : parts;
    C2D_EACH(i, circles) {
        c2d_find_around(i, body, levels, rule, status, circles, listStart, bucket, other, memory, bucketStart, horizon,
                        fall, true);
    }
    C2D_MEET;
    c2d_match_order_from(me, we, all.C2D_LEVELS > 1 ? contacts : 0, memory, bucket, listStart, circles, other);
    C2D_MEET;
    if (me == 0 && !full) {
        status[C2D_UPDATES] += 1u;
    }
    c2d_match_from(me, we, contacts, from, other, listStartBefore, otherBefore, memoryBefore, memory, batch);
    C2D_MEET;

    C2D_EACH(k, contacts) {
        c2d_batch_count_at(k, body, all, tilings, rule, other, capacity, batch, tileStart);
    }
    C2D_EACH(p, circles) { from[p] = atomic_inc(&tileStart[c2d_batch_part(p, body, all, tilings, rule, tiles) + 1]); }
    C2D_MEET;
    c2d_scan_shares(tileStart, parts, -1, partSums, status, group, groups, meeting, &expected, scratch);
    C2D_EACH(k, contacts) { c2d_batch_fill_at(k, capacity, batch, tileStart, byTile); }
    C2D_EACH(p, circles) {
        members[tileStart[c2d_batch_part(p, body, all, tilings, rule, tiles)] - contacts + from[p]] = p;
        from[p] = 0;
        mask[p] = 0ul;
    }
    C2D_MEET;
    const int others = C2D_PARTS * tilings[1].C2D_FIRST;
    for (int number = 0; number < (full ? 0 : all.C2D_LEVELS); number++) {
        const int8 level = levels[1 + number];
        const int rows = number == 0 ? 2 : 3;
        for (int colour = 0; colour < 3 * rows; colour++) {
            const int x = colour % 3;
            const int y = colour / 3;
            const int across = (level.C2D_WIDTH - x + 2) / 3;
            C2D_EACH(k, across * ((level.C2D_HEIGHT - y + rows - 1) / rows)) {
                c2d_batch_colour_bucket(k, level, x, y, rows, across, listStart, other, bucketStart, levels, status,
                                        capacity, batch, mask, from, tint, others);
            }
            C2D_MEET;
        }
    }
    const bool solves = !full && status[C2D_STALLED] == 0u;

    // as many tiles at a time as there are teams of the size that suits one; the last has what is left of the group
    const int teams = max(1, items / C2D_TEAM);
    const int team = min(here / (items / teams), teams - 1);
    const int item = here - team * (items / teams);
    const int teamItems = team == teams - 1 ? items - team * (items / teams) : items / teams;
    __local int *shared = scratch + teams * C2D_COUNTS;
    for (int tile = group * teams; tile < (solves ? tiles : 0); tile += groups * teams) {
        c2d_batch_order_tile(tile + team < tiles ? tile + team : -1, item, teamItems, other, byTile, tint, capacity,
                             batch, pairs, tileStart, tileColours, scratch + team * C2D_COUNTS, shared);
    }
    C2D_MEET;
    for (int pass = 0; pass < (solves ? substeps * tilingCount : 0); pass++) {
        const int tiling = pass % tilingCount;
        const int end = tiling + 1 < tilingCount ? tilings[tiling + 1].C2D_FIRST : tiles;
        for (int first = tilings[tiling].C2D_FIRST + group * teams; first < end; first += groups * teams) {
            const int tile = first + team;
            if (tiling == 0 && tile < end) {
                c2d_solve_members(tile, item, teamItems, pass > 0, members, tiles, body, id, kicked, walls, rule,
                                  (__global float2 *)memory, pairs, capacity, batch, tileStart, tileColours, status);
            }
            const int colours = tile < end ? c2d_solve_colours(tile, tileStart, tileColours) : 0;
            if (here == 0) {
                *shared = 0;
            }
            barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
            if (item == 0) {
                atomic_max(shared, colours);
            }
            barrier(CLK_LOCAL_MEM_FENCE);
            const int rounds = *shared;
            barrier(CLK_LOCAL_MEM_FENCE);
            c2d_solve_tile(tile, item, teamItems, colours, rounds, body, id, kicked, walls, rule,
                           (__global float2 *)memory, pairs, capacity, batch, tileStart, tileColours, status);
        }
        C2D_MEET;
    }
    uint fastest = 0u;
    C2D_EACH(i, solves && how.C2D_LAST != 0 ? circles : 0) {
        fastest = max(fastest, c2d_publish_circle(i, body, id, kicked, walls, rule, circle, velocities));
    }
    if (here == 0) {
        *shared = 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    // speeds are not negative: their bits compare as ints do
    atomic_max(shared, (int)fastest);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (here == 0) {
        atomic_max(&status[C2D_FASTEST], (uint)*shared);
    }
}
#endif
