// What stats.cl is for the contacts of Solver.IMPULSE, as the step found them. One work-item for C2D_PART contacts.

__kernel void c2d_stats_found(__global const float4 *circle, __global const int4 *found, int contacts,
                              __global uint4 *parts) {
    const int part = (int)get_global_id(0);
    if (part >= (contacts + C2D_PART - 1) / C2D_PART) {
        return;
    }
    c2d_overlaps all = {0ul, 0u, 0.0f};
    for (int k = C2D_PART * part; k < min(contacts, C2D_PART * (part + 1)); k++) {
        const int4 contact = found[k];
        const float x = as_float(contact.z);
        const float y = as_float(contact.w);
        const float a = circle[contact.x].z;
        const float b = circle[contact.y].z;
        all = c2d_with_overlap(all, sqrt(x * x + y * y), a < b ? a : b);
    }
    parts[part] = c2d_packed(all);
}
