package io.github.circles2d.bench.peers;

import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.physics.box2d.Body;
import com.badlogic.gdx.physics.box2d.BodyDef;
import com.badlogic.gdx.physics.box2d.Box2D;
import com.badlogic.gdx.physics.box2d.CircleShape;
import com.badlogic.gdx.physics.box2d.FixtureDef;
import com.badlogic.gdx.physics.box2d.PolygonShape;
import com.badlogic.gdx.physics.box2d.Shape;
import com.badlogic.gdx.physics.box2d.World;
import com.badlogic.gdx.utils.GdxNativesLoader;

/**
 * libGDX's Box2D, version 2 in C++, with 8 and 3 iterations, no sleep, no continuous collision. Its greatest way in a step, 2, is a
 * constant of its code.
 */
public final class GdxEngine implements Engine {
    private final World world;
    private final Body[] bodies;
    private final float scale;

    public GdxEngine(Pile pile) {
        GdxNativesLoader.load();
        Box2D.init();
        scale = (float) pile.scale();
        world = new World(new Vector2(0, (float) -pile.gravity()), false);
        world.setContinuousPhysics(false);
        World.setVelocityThreshold((float) pile.restingSpeed());
        for (float[] wall : pile.walls()) {
            PolygonShape box = new PolygonShape();
            box.setAsBox(wall[2], wall[3]);
            body(pile, BodyDef.BodyType.StaticBody, wall[0], wall[1], box, 0);
        }
        bodies = new Body[pile.count()];
        for (int i = 0; i < bodies.length; i++) {
            float r = pile.radius()[i];
            CircleShape circle = new CircleShape();
            circle.setRadius(r);
            float density = (float) (pile.mass()[i] / (Math.PI * r * r));
            bodies[i] = body(pile, BodyDef.BodyType.DynamicBody, pile.x()[i], pile.y()[i], circle, density);
        }
    }

    private Body body(Pile pile, BodyDef.BodyType type, float x, float y, Shape shape, float density) {
        BodyDef def = new BodyDef();
        def.type = type;
        def.allowSleep = false;
        def.position.set(x, y);
        FixtureDef fixture = new FixtureDef();
        fixture.shape = shape;
        fixture.density = density;
        fixture.friction = 0;
        fixture.restitution = (float) pile.restitution();
        Body body = world.createBody(def);
        body.createFixture(fixture);
        shape.dispose();
        return body;
    }

    @Override
    public void step() {
        world.step(Pile.STEP, 8, 3);
    }

    @Override
    public void read(float[] x, float[] y, float[] vx, float[] vy) {
        for (int i = 0; i < bodies.length; i++) {
            Vector2 centre = bodies[i].getPosition();
            x[i] = centre.x / scale;
            y[i] = centre.y / scale;
            Vector2 velocity = bodies[i].getLinearVelocity();
            vx[i] = velocity.x / scale;
            vy[i] = velocity.y / scale;
        }
    }

    @Override
    public void close() {
        world.dispose();
    }
}
