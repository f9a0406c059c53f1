package io.github.circles2d;

/**
 * What a circle starts as. Mutable and reusable: {@link Circles2D#addCircle(CircleDef)} copies it. Values are checked
 * there. Defaults: radius 0.01, mass 1, at rest at the origin.
 */
public final class CircleDef {
    float x;
    float y;
    float radius = 0.01f;
    float mass = 1;
    float vx;
    float vy;

    /** Centre, world units. */
    public CircleDef position(float x, float y) {
        this.x = x;
        this.y = y;
        return this;
    }

    /** Radius, world units. */
    public CircleDef radius(float radius) {
        this.radius = radius;
        return this;
    }

    /** Mass, in the caller's unit. */
    public CircleDef mass(float mass) {
        this.mass = mass;
        return this;
    }

    /** Velocity, world units a second. */
    public CircleDef velocity(float vx, float vy) {
        this.vx = vx;
        this.vy = vy;
        return this;
    }
}
