// What stats.cl is for the contacts of Solver.SMALL_STEPS, as they are after the step. One work-item for the lists of C2D_PART
// circles.

__kernel void c2d_stats_lists(C2D_WORLD, __global uint4 *parts) {
    __global const float8 *body = C2D_BODY;
    __global const int *listStart = C2D_LIST_START;
    __global const int *other = C2D_OTHER;
    const int circles = world.circles;
    const int part = (int)get_global_id(0);
    if (part >= (circles + C2D_PART - 1) / C2D_PART) {
        return;
    }
    c2d_overlaps all = {0ul, 0u, 0.0f};
    for (int i = C2D_PART * part; i < min(circles, C2D_PART * (part + 1)); i++) {
        const float8 a = body[i];
        for (int k = listStart[i]; k < listStart[i + 1]; k++) {
            const float8 b = body[other[k]];
            const float dx = a.s0 - b.s0;
            const float dy = a.s1 - b.s1;
            const float smaller = a.s6 < b.s6 ? a.s6 : b.s6;
            all = c2d_with_overlap(all, a.s6 + b.s6 - sqrt(dx * dx + dy * dy), smaller);
        }
    }
    parts[part] = c2d_packed(all);
}
