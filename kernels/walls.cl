// The rule of a wall: that of a contact, visit.cl, with something that does not move; and the motion of a substep, which goes no
// farther than the walls. Twin of host.Integrate.

// One coordinate of a circle. A struct, not an array: arrays with an index go to slow memory.
typedef struct {
    float position;
    float velocity;
    float kick;
} c2d_axis;

static bool c2d_near_wall(c2d_axis a, float sign, float gap, float radius, c2d_numbers n) {
    return gap < 2.0f * radius || gap + sign * a.velocity * n.time < 0.0f;
}

// A wall, as a contact with something that does not move. `sign` leads inside, `kicked` is the kick in the velocity. `memory`:
// the impulse to come and the last one.
static c2d_axis c2d_small_wall(c2d_axis a, float sign, float gap, float radius, float w, float kicked, bool carried,
                               float gain, float2 *memory, c2d_numbers n) {
    if (!c2d_near_wall(a, sign, gap, radius, n)) {
        return a;
    }
    const float speed = sign * a.velocity;
    const float come = (*memory).x;
    const float last = (*memory).y;
    float impulse = come - (speed + c2d_positive(gap) * n.perTime) / w;
    bool bounced = false;
    if (!(impulse > 0.0f)) {
        impulse = 0.0f;
    } else if (come == 0.0f) {
        const float before = speed - sign * (kicked + gain);
        if (before < -n.bounceFrom && !(last < 0.0f && carried)) {
            bounced = true;
            impulse = c2d_positive(-(speed + n.restitution * before) / w);
        }
    }
    const float push = n.push * c2d_positive(-gap - n.slop * radius);
    const float most = n.pushMost * radius;
    a.position += sign * (push < most ? push : most);
    a.velocity += sign * (w * (impulse - come));
    float next = 0.0f;
    if (!bounced && impulse > 0.0f) {
        next = c2d_extrapolated(impulse, last, n.extrapolate, n.impulseMost);
        a.kick += sign * (w * next);
    }
    *memory = (float2)(next, bounced ? -1.0f : impulse);
    return a;
}

// What a circle needs for its own share of a substep.
#define C2D_CIRCLES                                                                                                    \
    __global const int *id, __global float2 *kicked, __global float2 *walls, const c2d_numbers numbers
#define C2D_CIRCLES_HERE C2D_ID, C2D_KICKED, C2D_WALLS, world.numbers

// Whether either wall of an axis is near.
static bool c2d_near_either(c2d_axis a, c2d_along along, float radius, c2d_numbers n) {
    return c2d_near_wall(a, 1.0f, a.position - along.min - radius, radius, n) ||
           c2d_near_wall(a, -1.0f, along.max - a.position - radius, radius, n);
}

// Both walls of an axis, those of circle i; gaps are those before either moves the circle.
static c2d_axis c2d_both_walls(c2d_axis a, int axis, float radius, float w, int i, C2D_CIRCLES) {
    const c2d_along along = axis == 0 ? numbers.x : numbers.y;
    if (!c2d_near_either(a, along, radius, numbers)) {
        return a;
    }
    const float low = a.position - along.min - radius;
    const float high = along.max - a.position - radius;
    const float2 u = kicked[i];
    const bool carried = u.x != 0.0f || u.y != 0.0f;
    __global float2 *own = walls + 2 * id[i] + axis;
    const float2 was = *own;
    float2 memoryLow = (float2)(0.0f, 0.0f);
    float2 memoryHigh = memoryLow;
    // one after the other: compilers take their time over what they unroll
#pragma unroll 1
    for (int side = 0; side < 2; side++) {
        const float sign = side == 0 ? 1.0f : -1.0f;
        float2 memory = c2d_of_wall(was, sign);
        a = c2d_small_wall(a, sign, side == 0 ? low : high, radius, w, axis == 0 ? u.x : u.y, carried, along.gain, &memory, numbers);
        memoryLow = side == 0 ? memory : memoryLow;
        memoryHigh = memory;
    }
    const float2 now = c2d_of_walls(memoryLow, memoryHigh);
    if (now.x != was.x || now.y != was.y) {
        *own = now;
    }
    return a;
}

// The way of a substep along an axis.
static c2d_axis c2d_small_move(c2d_axis a, c2d_along along, float radius, c2d_numbers n) {
    const float half_radius = 0.5f * radius;
    const float min = along.min + half_radius;
    const float max = along.max - half_radius;
    a.position += n.time * a.velocity;
    if (!(a.position >= min)) {
        a.position = min;
        a.velocity = a.velocity < 0.0f ? -n.restitution * a.velocity : a.velocity;
    } else if (a.position > max) {
        a.position = max;
        a.velocity = a.velocity > 0.0f ? -n.restitution * a.velocity : a.velocity;
    }
    return a;
}
