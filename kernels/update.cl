// Moves every circle through one time step of constant acceleration and off the walls (thesis, chapters 3 and 4).
// One work-item a circle. It also empties the contacts of the step before.

// A coordinate and its velocity against two walls; lo and hi bound the centre. Twin of host.Update.axis.
static float2 c2d_wall(float position, float velocity, float lo, float hi, float restitution) {
    if (position < lo) {
        position = lo + restitution * (lo - position);
        velocity = velocity < 0.0f ? -restitution * velocity : velocity;
    } else if (position > hi) {
        position = hi - restitution * (position - hi);
        velocity = velocity > 0.0f ? -restitution * velocity : velocity;
    }
    // faster than the world is wide: the far wall holds as well
    position = position < lo ? lo : position;
    position = position > hi ? hi : position;
    return (float2)(position, velocity);
}

// velocityGain = gravity * timeStep, fall = gravity * timeStep^2 / 2; bounds = (minX, minY, maxX, maxY).
__kernel void c2d_update(__global float4 *circle, __global float2 *velocities, __global int *cellStart,
                         __global uint *status, int circles, int cells, float timeStep, float2 velocityGain,
                         float2 fall, float4 bounds, float restitution) {
    if (status[C2D_STALLED] != 0u) {
        return;
    }
    const int i = (int)get_global_id(0);
    if (i == 0) {
        status[C2D_CONTACTS] = 0u;
        status[C2D_UPDATES] += 1u;
    }
    if (i < cells) {
        cellStart[i] = 0;
    }
    if (i < circles) {
        const float4 c = circle[i];
        const float2 v = velocities[i];
        const float2 position = c.xy + (v * timeStep + fall);
        const float2 velocity = v + velocityGain;
        const float2 x = c2d_wall(position.x, velocity.x, bounds.x + c.z, bounds.z - c.z, restitution);
        const float2 y = c2d_wall(position.y, velocity.y, bounds.y + c.z, bounds.w - c.z, restitution);
        circle[i].xy = (float2)(x.x, y.x);
        velocities[i] = (float2)(x.y, y.y);
    }
}
