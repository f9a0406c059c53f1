package io.github.circles2d.pipeline;

import io.github.circles2d.CollisionStore;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;

/** What tests of the insides of {@link Solver#SMALL_STEPS} build their worlds from. */
public final class SmallSteps {
    private SmallSteps() {}

    /**
     * A box from the origin, 1 high, with the gravity and the restitution that worlds have.
     *
     * @param width of the box
     * @param oneTile as {@link WorldConfig} says
     */
    public static WorldConfig box(float width, int oneTile) {
        return box(width, oneTile, -1);
    }

    /** The same with another gravity, downwards below 0. */
    static WorldConfig box(float width, int oneTile, float gravity) {
        return box(width, oneTile, gravity, 60, 8);
    }

    /** The same with so many steps a second and substeps a step. */
    static WorldConfig box(float width, int oneTile, float gravity, int steps, int substeps) {
        return new WorldConfig(
                1f / steps,
                0,
                gravity,
                0.5f,
                0,
                0,
                width,
                1,
                IndexStrategy.grid(),
                CollisionStore.COMPACT,
                Solver.SMALL_STEPS,
                0,
                0,
                0,
                oneTile,
                substeps);
    }

    /** All circles, as those that have come or changed. */
    static Changes all(int circles) {
        Changes all = new Changes();
        for (int i = 0; i < circles; i++) {
            all.add(i);
        }
        return all;
    }

    /** Stages that a test stands in for, or between. */
    static SmallStages stages(InvocationHandler handler) {
        return (SmallStages)
                Proxy.newProxyInstance(SmallStages.class.getClassLoader(), new Class<?>[] {SmallStages.class}, handler);
    }

    /** Centre, radius, angle and velocity of each of so many circles, as bits. */
    public static int[] bits(FloatBuffer transforms, FloatBuffer velocities, int circles) {
        int[] bits = new int[6 * circles];
        for (int k = 0; k < 4 * circles; k++) {
            bits[k] = Float.floatToRawIntBits(transforms.get(k));
        }
        for (int k = 0; k < 2 * circles; k++) {
            bits[4 * circles + k] = Float.floatToRawIntBits(velocities.get(k));
        }
        return bits;
    }

    /** Memory for so many floats as stages take it: direct, native order. */
    public static FloatBuffer direct(int floats) {
        return ByteBuffer.allocateDirect(4 * floats)
                .order(ByteOrder.nativeOrder())
                .asFloatBuffer();
    }
}
