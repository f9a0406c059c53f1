// The rule of one contact: Solver.IMPULSE (thesis, chapter 3, and kernels 5 to 7 of chapter 4). Twin of host.Contact, where
// it is explained.

// A contact made ready: what does not depend on the contacts before it.
//   .s0 .s1  numbers of its circles; the rest are floats, as bits
//   .s2 .s3  normal, from the first to the second
//   .s4 .s5  how far each is moved along it
//   .s6 .s7  what each gains in velocity for an approach of 1
static int8 c2d_prepare(int4 found, __global const float4 *circle, float restitution) {
    const float tx = as_float(found.z);
    const float ty = as_float(found.w);
    const float depth = sqrt(tx * tx + ty * ty);
    const float inverseA = 1.0f / circle[found.x].w;
    const float inverseB = 1.0f / circle[found.y].w;
    const float inverseSum = inverseA + inverseB;
    const float shareA = inverseA / inverseSum;
    const float shareB = inverseB / inverseSum;
    const float bounce = 1.0f + restitution;
    return (int8)(found.x, found.y, as_int(tx / depth), as_int(ty / depth), as_int(depth * shareA),
                  as_int(depth * shareB), as_int(bounce * shareA), as_int(bounce * shareB));
}

// A centre moved off a circle stays within the walls.
static float c2d_within(float position, float lo, float hi) {
    const float low = position < lo ? lo : position;
    return low > hi ? hi : low;
}

static void c2d_resolve_contact(int8 contact, __global float4 *circle, __global float2 *velocities,
                                float4 bounds) {
    const int i = contact.s0;
    const int j = contact.s1;
    const float nx = as_float(contact.s2);
    const float ny = as_float(contact.s3);
    const float moveA = as_float(contact.s4);
    const float moveB = as_float(contact.s5);
    const float4 a = circle[i];
    const float4 b = circle[j];
    const float2 va = velocities[i];
    const float2 vb = velocities[j];
    circle[i].xy = (float2)(c2d_within(a.x - moveA * nx, bounds.x + a.z, bounds.z - a.z),
                            c2d_within(a.y - moveA * ny, bounds.y + a.z, bounds.w - a.z));
    circle[j].xy = (float2)(c2d_within(b.x + moveB * nx, bounds.x + b.z, bounds.z - b.z),
                            c2d_within(b.y + moveB * ny, bounds.y + b.z, bounds.w - b.z));
    const float approach = (va.x - vb.x) * nx + (va.y - vb.y) * ny;
    if (approach > 0.0f) {
        const float lossA = as_float(contact.s6) * approach;
        const float lossB = as_float(contact.s7) * approach;
        velocities[i] = (float2)(va.x - lossA * nx, va.y - lossA * ny);
        velocities[j] = (float2)(vb.x + lossB * nx, vb.y + lossB * ny);
    }
}
