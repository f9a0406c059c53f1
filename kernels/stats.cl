// What a step looks like, in parts that the host adds up: one work-item for C2D_PART circles or contacts, in order, so that the
// order of the sums is always the same. Twin of host.Stats.

#define C2D_PART 64

// A sum and what rounding has taken from it (Neumaier, 1974).
static float2 c2d_plus(float2 sum, float x) {
    const float next = sum.x + x;
    const float lost = fabs(sum.x) >= fabs(x) ? (sum.x - next) + x : (x - next) + sum.x;
    return (float2)(next, sum.y + lost);
}

// Of circles by number: kinetic energy, momentum, highest speed, how many are outside. `inside`: the share of its radius that
// the centre of a circle keeps from the walls.
__kernel void c2d_stats_circles(__global const float4 *circle, __global const float2 *velocities, int circles,
                                float4 bounds, float inside, __global float8 *parts) {
    const int part = (int)get_global_id(0);
    if (part >= (circles + C2D_PART - 1) / C2D_PART) {
        return;
    }
    float2 energy = (float2)(0.0f, 0.0f);
    float2 momentumX = energy;
    float2 momentumY = energy;
    float fastest = 0.0f;
    int outside = 0;
    for (int i = C2D_PART * part; i < min(circles, C2D_PART * (part + 1)); i++) {
        const float4 c = circle[i];
        const float2 v = velocities[i];
        const float square = v.x * v.x + v.y * v.y;
        const float speed = sqrt(square);
        const float margin = inside * c.z;
        energy = c2d_plus(energy, 0.5f * c.w * square);
        momentumX = c2d_plus(momentumX, c.w * v.x);
        momentumY = c2d_plus(momentumY, c.w * v.y);
        fastest = speed > fastest ? speed : fastest;
        // NaN is outside
        outside += c.x >= bounds.x + margin && c.x <= bounds.z - margin && c.y >= bounds.y + margin &&
                           c.y <= bounds.w - margin
                       ? 0
                       : 1;
    }
    parts[part] = (float8)(energy.x, energy.y, momentumX.x, momentumX.y, momentumY.x, momentumY.y, fastest,
                           (float)outside);
}

// Of contacts: how many touch, the largest overlap, and the sum of overlaps in units of 2^-24, all of smaller radii. Whole
// numbers, which do not care for an order.
typedef struct {
    ulong sum;
    uint touching;
    float largest;
} c2d_overlaps;

static c2d_overlaps c2d_with_overlap(c2d_overlaps all, float depth, float smaller) {
    if (depth > 0.0f) {
        const float overlap = depth / smaller;
        all.touching++;
        all.largest = overlap > all.largest ? overlap : all.largest;
        all.sum += (ulong)((overlap < 4096.0f ? overlap : 4096.0f) * 16777216.0f);
    }
    return all;
}

static uint4 c2d_packed(c2d_overlaps all) {
    return (uint4)((uint)all.sum, (uint)(all.sum >> 32), all.touching, as_uint(all.largest));
}
