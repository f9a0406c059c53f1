// Lists the pairs of circles that may touch before the next detection, those of neighbouring cells of the wider of their two
// levels. Twice: to count, and to fill the lists. By the grid, find_grid.cl, or by the index strategy, find_pairs.cl. Twin of
// host.Find.

// What find knows. `filled`, from `circles` on: how much of each list is filled from its start; `found`: of each contact the
// other circle and the one in whose list it is.
#define C2D_FIND                                                                                                       \
    __global const float8 *body, __global const int8 *levels, const c2d_numbers numbers, __global const uint *status,   \
        int circles, __global int *listStart, __global int *filled, __global int *other, __global int2 *found
#define C2D_FILLED C2D_AT(int, kicked)
#define C2D_FOUND C2D_AT(int2, found)
#define C2D_FIND_HERE                                                                                                  \
    C2D_BODY, C2D_LEVEL_TABLE, world.numbers, status, world.circles, C2D_LIST_START, C2D_FILLED, C2D_OTHER, C2D_FOUND

// Whether two circles may touch within the horizon, in which they may come nearer by `slack` than they go now, with a gap of
// `always` smaller radii to spare; the same whichever comes first.
static bool c2d_near(float8 a, float8 b, float always, float horizon, float slack) {
    const float dx = a.s0 - b.s0;
    const float dy = a.s1 - b.s1;
    const float dvx = a.s2 - b.s2;
    const float dvy = a.s3 - b.s3;
    const float travel = sqrt(dvx * dvx + dvy * dvy) * horizon;
    const float smaller = a.s6 < b.s6 ? a.s6 : b.s6;
    const float reach = a.s6 + b.s6 + always * smaller + slack + travel;
    return dx * dx + dy * dy < reach * reach;
}

// After a detection that stalled, where there were more pairs than room: puts the circles back to where they were before it,
// for what is kept has taken their place.
__kernel void c2d_find_restore(C2D_WORLD) {
    const int p = (int)get_global_id(0);
    if (p < world.circles) {
        C2D_AT(float8, bodyBefore)[C2D_FROM[p]] = C2D_BODY[p];
    }
}
