// A substep's share of each circle alone: at its start gravity and kicks, at its end walls and motion. One work-item a circle.
// Twin of host.Integrate. Also how circles come into the order of the cells and back.

static c2d_axis c2d_small_kick(c2d_axis a, c2d_along along, float slowed) {
    const float most = along.speed;
    const float velocity = a.velocity * slowed + (along.gain + a.kick);
    const float low = velocity < most ? velocity : most;
    a.velocity = low > -most ? low : -most;
    a.kick = 0.0f;
    return a;
}

// Of circle i, which is as `b` says: the end of a substep, `move`, the start of one, `kick`, or both.
static float8 c2d_integrated(float8 b, int i, bool move, bool kick, C2D_CIRCLES) {
    c2d_axis x = {b.s0, b.s2, b.s4};
    c2d_axis y = {b.s1, b.s3, b.s5};
    // most circles are near no wall: they read nothing of walls, nor what kicked them
    if (move && (c2d_near_either(x, numbers.x, b.s6, numbers) || c2d_near_either(y, numbers.y, b.s6, numbers))) {
        // one after the other: compilers take their time over what they unroll; after two turns each is where it was
#pragma unroll 1
        for (int axis = 0; axis < 2; axis++) {
            const c2d_axis pushed = c2d_both_walls(x, axis, b.s6, b.s7, i, id, kicked, walls, numbers);
            x = y;
            y = pushed;
        }
    }
    if (move) {
        x = c2d_small_move(x, numbers.x, b.s6, numbers);
        y = c2d_small_move(y, numbers.y, b.s6, numbers);
    }
    if (kick) {
        const float slowed = x.kick != 0.0f || y.kick != 0.0f ? numbers.slowed : 1.0f;
        kicked[i] = (float2)(x.kick, y.kick);
        x = c2d_small_kick(x, numbers.x, slowed);
        y = c2d_small_kick(y, numbers.y, slowed);
    }
    return (float8)(x.position, y.position, x.velocity, y.velocity, x.kick, y.kick, b.s6, b.s7);
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

// The end of a step for circle i, which is as `b` says: makes it known by its number. Returns how it moves, as bits, or those of `motion`
// that move more. Positive floats compare as their bits do.
static uint8 c2d_publish(float8 b, int to, __global float4 *circle, __global float2 *velocities, uint8 motion) {
    const float dx = b.s0 - circle[to].x;
    const float dy = b.s1 - circle[to].y;
    const float speed = b.s2 * b.s2 + b.s3 * b.s3;
    circle[to].xy = b.s01;
    velocities[to] = b.s23;
    return max(motion, (uint8)(as_uint(c2d_positive(sqrt(speed) / b.s6)), as_uint(c2d_positive(dx * dx + dy * dy)),
                               as_uint(c2d_positive(speed)), as_uint(c2d_positive(b.s2)), as_uint(c2d_positive(-b.s2)),
                               as_uint(c2d_positive(b.s3)), as_uint(c2d_positive(-b.s3)), 0u));
}

static void c2d_publish_most(uint8 motion, volatile __local uint *most) {
    atomic_max(&most[0], motion.s0);
    atomic_max(&most[1], motion.s1);
    atomic_max(&most[2], motion.s2);
    atomic_max(&most[3], motion.s3);
    atomic_max(&most[4], motion.s4);
    atomic_max(&most[5], motion.s5);
    atomic_max(&most[6], motion.s6);
}

// A step goes `on` with contacts that one before has listed, or has listed its own.
static void c2d_publish_gone(__global uint *status, bool on) {
    const float gone = as_float(status[C2D_GONE]) + sqrt(as_float(status[C2D_MOVED_SQUARE]));
    status[C2D_GONE] = as_uint(on ? gone : 0.0f);
}

// Before the first substep of a detection, or of a step that goes `on` with one.
static void c2d_publish_clear(__global uint *status, bool on) {
    if (get_global_id(0) == 0) {
        c2d_publish_gone(status, on);
    }
    for (int k = 0; k < C2D_MOTIONS && get_global_id(0) == 0; k++) {
        status[C2D_MOTION + k] = 0u;
    }
}

// The end of a substep; of the last of a step, which `publishes`, also the circles by number.
__kernel void c2d_integrate(C2D_WORLD, int publishes, __global float4 *circle, __global float2 *velocities, __local uint *most) {
    const int i = (int)get_global_id(0);
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    for (int k = item; k < C2D_MOTIONS; k += items) {
        most[k] = 0u;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    if (i < world.circles && status[C2D_STALLED] == 0u) {
        const float8 b = c2d_integrated(C2D_BODY[i], i, true, false, C2D_CIRCLES_HERE);
        C2D_BODY[i] = b;
        if (publishes) {
            c2d_publish_most(c2d_publish(b, C2D_ID[i], circle, velocities, (uint8)(0u)), most);
        }
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int k = item; k < C2D_MOTIONS && publishes; k += items) {
        atomic_max(&status[C2D_MOTION + k], most[k]);
    }
}
