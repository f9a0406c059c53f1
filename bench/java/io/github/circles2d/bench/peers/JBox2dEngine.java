package io.github.circles2d.bench.peers;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.Body;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;

/**
 * JBox2D with 8 and 3 iterations, no sleep, no continuous collision. Its greatest way in a step, 2, and the speed below which nothing
 * bounces, 1, are constants of its code.
 */
public final class JBox2dEngine implements Engine {
    private final World world;
    private final Body[] bodies;
    private final float scale;

    public JBox2dEngine(Pile pile) {
        scale = (float) pile.scale();
        world = new World(new Vec2(0, (float) -pile.gravity()));
        world.setSleepingAllowed(false);
        world.setContinuousPhysics(false);
        for (float[] wall : pile.walls()) {
            PolygonShape box = new PolygonShape();
            box.setAsBox(wall[2], wall[3]);
            body(pile, BodyType.STATIC, wall[0], wall[1], box, 0);
        }
        bodies = new Body[pile.count()];
        for (int i = 0; i < bodies.length; i++) {
            float r = pile.radius()[i];
            CircleShape circle = new CircleShape();
            circle.m_radius = r;
            float density = (float) (pile.mass()[i] / (Math.PI * r * r));
            bodies[i] = body(pile, BodyType.DYNAMIC, pile.x()[i], pile.y()[i], circle, density);
        }
    }

    private Body body(Pile pile, BodyType type, float x, float y, Shape shape, float density) {
        BodyDef def = new BodyDef();
        def.type = type;
        def.position.set(x, y);
        FixtureDef fixture = new FixtureDef();
        fixture.shape = shape;
        fixture.density = density;
        fixture.friction = 0;
        fixture.restitution = (float) pile.restitution();
        Body body = world.createBody(def);
        body.createFixture(fixture);
        return body;
    }

    @Override
    public void step() {
        world.step(Pile.STEP, 8, 3);
    }

    @Override
    public void read(float[] x, float[] y, float[] vx, float[] vy) {
        for (int i = 0; i < bodies.length; i++) {
            Vec2 centre = bodies[i].getPosition();
            Vec2 velocity = bodies[i].getLinearVelocity();
            x[i] = centre.x / scale;
            y[i] = centre.y / scale;
            vx[i] = velocity.x / scale;
            vy[i] = velocity.y / scale;
        }
    }

    @Override
    public void close() {
        // its memory is Java's
    }
}
