package io.github.circles2d.bench.peers;

import java.util.ArrayList;
import java.util.List;
import org.dyn4j.dynamics.Body;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.dynamics.ContinuousDetectionMode;
import org.dyn4j.dynamics.Settings;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.Mass;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.World;

/** dyn4j with its own defaults but: no sleep, no continuous detection, no limit that the fall would meet. */
public final class Dyn4jEngine implements Engine {
    private final World<Body> world = new World<>();
    private final List<Body> bodies = new ArrayList<>();
    private final double scale;

    public Dyn4jEngine(Pile pile) {
        scale = pile.scale();
        world.setGravity(0, -pile.gravity());
        Settings settings = world.getSettings();
        settings.setStepFrequency(Pile.STEP);
        settings.setAtRestDetectionEnabled(false);
        settings.setContinuousDetectionMode(ContinuousDetectionMode.NONE);
        settings.setMaximumTranslation(Pile.WALL / 2);
        for (float[] wall : pile.walls()) {
            Body body = new Body();
            fixture(body, pile, new BodyFixture(Geometry.createRectangle(2 * wall[2], 2 * wall[3])));
            body.translate(wall[0], wall[1]);
            body.setMass(MassType.INFINITE);
            world.addBody(body);
        }
        for (int i = 0; i < pile.count(); i++) {
            Body body = new Body();
            double r = pile.radius()[i];
            double mass = pile.mass()[i];
            fixture(body, pile, new BodyFixture(Geometry.createCircle(r)));
            body.setMass(new Mass(new Vector2(), mass, mass * r * r / 2));
            body.translate(pile.x()[i], pile.y()[i]);
            body.setLinearDamping(0);
            body.setAngularDamping(0);
            bodies.add(body);
            world.addBody(body);
        }
    }

    private static void fixture(Body body, Pile pile, BodyFixture fixture) {
        fixture.setFriction(0);
        fixture.setRestitution(pile.restitution());
        fixture.setRestitutionVelocity(pile.restingSpeed());
        body.addFixture(fixture);
    }

    @Override
    public void step() {
        world.step(1);
    }

    @Override
    public void read(float[] x, float[] y, float[] vx, float[] vy) {
        for (int i = 0; i < bodies.size(); i++) {
            Vector2 centre = bodies.get(i).getWorldCenter();
            Vector2 velocity = bodies.get(i).getLinearVelocity();
            x[i] = (float) (centre.x / scale);
            y[i] = (float) (centre.y / scale);
            vx[i] = (float) (velocity.x / scale);
            vy[i] = (float) (velocity.y / scale);
        }
    }

    @Override
    public void close() {
        world.removeAllBodies();
    }
}
