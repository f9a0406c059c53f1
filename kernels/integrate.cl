// A substep's share of each circle alone: at its start gravity and kicks, at its end walls and motion. One work-item a circle.
// Twin of host.Integrate. Also how circles come into the order of the cells and back.

// One coordinate of a circle. A struct, not an array: arrays with an index go to slow memory.
typedef struct {
    float position;
    float velocity;
    float kick;
} c2d_axis;

static bool c2d_near_wall(c2d_axis a, float sign, float gap, float radius, __global const float *rule) {
    return gap < 2.0f * radius || gap + sign * a.velocity * C2D_TIME < 0.0f;
}

// A wall, as a contact with something that does not move. `sign` leads inside, `kicked` is the kick in the velocity. `memory`:
// the impulse to come and the last one.
static c2d_axis c2d_small_wall(c2d_axis a, float sign, float gap, float radius, float w, float kicked, bool carried,
                               float gain, float2 *memory, __global const float *rule) {
    if (!c2d_near_wall(a, sign, gap, radius, rule)) {
        return a;
    }
    const float speed = sign * a.velocity;
    const float come = (*memory).x;
    const float last = (*memory).y;
    float impulse = come - (speed + c2d_positive(gap) * C2D_PER_TIME) / w;
    bool bounced = false;
    if (!(impulse > 0.0f)) {
        impulse = 0.0f;
    } else if (come == 0.0f) {
        const float before = speed - sign * (kicked + gain);
        if (before < -C2D_BOUNCE_FROM && !(last < 0.0f && carried)) {
            bounced = true;
            impulse = c2d_positive(-(speed + C2D_RESTITUTION * before) / w);
        }
    }
    const float push = C2D_PUSH * c2d_positive(-gap - C2D_SLOP * radius);
    const float most = C2D_PUSH_MOST * radius;
    a.position += sign * (push < most ? push : most);
    a.velocity += sign * (w * (impulse - come));
    float next = 0.0f;
    if (!bounced && impulse > 0.0f) {
        next = c2d_extrapolated(impulse, last, C2D_EXTRAPOLATE, C2D_IMPULSE_MOST);
        a.kick += sign * (w * next);
    }
    *memory = (float2)(next, bounced ? -1.0f : impulse);
    return a;
}

// Both walls of an axis; gaps are those before either moves the circle. Then the way of the substep. `walls`: what is
// remembered of the axis, in a circle's order: see small.cl.
static c2d_axis c2d_small_move(c2d_axis a, int axis, float radius, float w, float kicked, bool carried,
                               __global float2 *walls, __global const float *rule) {
    const float low = a.position - C2D_MIN(axis) - radius;
    const float high = C2D_MAX(axis) - a.position - radius;
    // most circles are near none, and what is remembered of walls lies far apart in memory
    if (c2d_near_wall(a, 1.0f, low, radius, rule) || c2d_near_wall(a, -1.0f, high, radius, rule)) {
        const float2 was = *walls;
        float2 memoryLow = (float2)(0.0f, 0.0f);
        float2 memoryHigh = memoryLow;
        // one after the other: compilers take their time over what they unroll
#pragma unroll 1
        for (int side = 0; side < 2; side++) {
            const float sign = side == 0 ? 1.0f : -1.0f;
            float2 memory = c2d_of_wall(was, sign);
            a = c2d_small_wall(a, sign, side == 0 ? low : high, radius, w, kicked, carried, C2D_GAIN(axis), &memory, rule);
            memoryLow = side == 0 ? memory : memoryLow;
            memoryHigh = memory;
        }
        const float2 now = c2d_of_walls(memoryLow, memoryHigh);
        if (now.x != was.x || now.y != was.y) {
            *walls = now;
        }
    }
    const float half_radius = 0.5f * radius;
    const float min = C2D_MIN(axis) + half_radius;
    const float max = C2D_MAX(axis) - half_radius;
    a.position += C2D_TIME * a.velocity;
    if (!(a.position >= min)) {
        a.position = min;
        a.velocity = a.velocity < 0.0f ? -C2D_RESTITUTION * a.velocity : a.velocity;
    } else if (a.position > max) {
        a.position = max;
        a.velocity = a.velocity > 0.0f ? -C2D_RESTITUTION * a.velocity : a.velocity;
    }
    return a;
}

static c2d_axis c2d_small_kick(c2d_axis a, int axis, float slowed, __global const float *rule) {
    const float most = C2D_SPEED(axis);
    const float velocity = a.velocity * slowed + (C2D_GAIN(axis) + a.kick);
    const float low = velocity < most ? velocity : most;
    a.velocity = low > -most ? low : -most;
    a.kick = 0.0f;
    return a;
}

// What a circle needs for that.
#define C2D_CIRCLES                                                                                                    \
    __global float8 *body, __global const int *id, __global float2 *kicked, __global float2 *walls,                      \
        __global const float *rule
#define C2D_CIRCLES_HERE C2D_BODY, C2D_ID, C2D_KICKED, C2D_WALLS, C2D_RULE

// Of circle i: the end of a substep, `move`, the start of one, `kick`, or both.
static float8 c2d_integrated(int i, bool move, bool kick, C2D_CIRCLES) {
    const float8 b = body[i];
    c2d_axis x = {b.s0, b.s2, b.s4};
    c2d_axis y = {b.s1, b.s3, b.s5};
    if (move) {
        const float2 u = kicked[i];
        const bool carried = u.x != 0.0f || u.y != 0.0f;
        __global float2 *both = walls + 2 * id[i];
        x = c2d_small_move(x, 0, b.s6, b.s7, u.x, carried, both, rule);
        y = c2d_small_move(y, 1, b.s6, b.s7, u.y, carried, both + 1, rule);
    }
    if (kick) {
        const float slowed = x.kick != 0.0f || y.kick != 0.0f ? C2D_SLOWED : 1.0f;
        kicked[i] = (float2)(x.kick, y.kick);
        x = c2d_small_kick(x, 0, slowed, rule);
        y = c2d_small_kick(y, 1, slowed, rule);
    }
    return (float8)(x.position, y.position, x.velocity, y.velocity, x.kick, y.kick, b.s6, b.s7);
}

// The end of a substep.
__kernel void c2d_integrate(C2D_WORLD) {
    const int i = (int)get_global_id(0);
    if (i < world.circles && status[C2D_STALLED] == 0u) {
        C2D_BODY[i] = c2d_integrated(i, true, false, C2D_CIRCLES_HERE);
    }
}

// After an upload: what is new of the circles, `old` of which have a place already; the others come last.
__kernel void c2d_load(C2D_WORLD, __global const float4 *circle, __global const float2 *velocities, int old) {
    const int i = (int)get_global_id(0);
    if (i >= world.circles) {
        return;
    }
    const bool known = i < old;
    const int number = known ? C2D_ID[i] : i;
    const float4 c = circle[number];
    const float2 v = velocities[number];
    const float2 kick = known ? C2D_BODY[i].s45 : (float2)(0.0f, 0.0f);
    C2D_BODY[i] = (float8)(c.x, c.y, v.x, v.y, kick.x, kick.y, c.z, 1.0f / c.w);
    if (!known) {
        C2D_ID[i] = i;
        C2D_LIST_START[i + 1] = C2D_LIST_START[old];
    }
}

// Bits that compare as floats do; 0 comes before all of them.
static uint c2d_ordered(float x) { return as_uint(x) ^ ((as_uint(x) >> 31) != 0u ? 0xFFFFFFFFu : 0x80000000u); }

// The end of a step: that of its last substep, then the circles by number, and the highest speed, in radii a second. `ranges`: those
// of velocities too, or none. `highest`: for each of them.
__kernel void c2d_publish(C2D_WORLD, __global float4 *circle, __global float2 *velocities, int ranges,
                          __local uint *highest) {
    const int i = (int)get_global_id(0);
    for (int k = (int)get_local_id(0); k <= ranges; k += (int)get_local_size(0)) {
        highest[k] = 0u;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    if (i < world.circles && status[C2D_STALLED] == 0u) {
        const float8 b = c2d_integrated(i, true, false, C2D_CIRCLES_HERE);
        C2D_BODY[i] = b;
        const int to = C2D_ID[i];
        circle[to].xy = b.s01;
        velocities[to] = b.s23;
        // positive floats compare as their bits do
        atomic_max(&highest[0], as_uint(c2d_positive(sqrt(b.s2 * b.s2 + b.s3 * b.s3) / b.s6)));
        if (ranges > 0) {
            atomic_max(&highest[1], c2d_ordered(b.s2));
            atomic_max(&highest[2], c2d_ordered(-b.s2));
            atomic_max(&highest[3], c2d_ordered(b.s3));
            atomic_max(&highest[4], c2d_ordered(-b.s3));
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int k = (int)get_local_id(0); k <= ranges; k += (int)get_local_size(0)) {
        atomic_max(&status[C2D_FASTEST + k], highest[k]);
    }
}
