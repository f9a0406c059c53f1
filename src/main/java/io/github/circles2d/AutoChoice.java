package io.github.circles2d;

import io.github.circles2d.pipeline.Tuning;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.ConcurrentHashMap;

/**
 * What {@link IndexStrategy#auto()} stands for in a world.
 *
 * @param strategy the strategy
 * @param smallWorld largest world that one work-group does, circles
 */
record AutoChoice(IndexStrategy strategy, int smallWorld) {
    private static final System.Logger LOG = System.getLogger("io.github.circles2d");
    private static final Map<Kind, AutoChoice> MADE = new ConcurrentHashMap<>();

    /** Worlds that share a choice: `circles` is a power of two, or the most that one work-group does alone. */
    private record Kind(ComputeDevice device, Solver solver, CollisionStore store, int circles) {}

    /** The choice for a world, tried out unless one like it has been built before. */
    static AutoChoice of(ComputeDevice device, Solver solver, CollisionStore store, int capacity) {
        int circles = Math.max(Tuning.FIRST_CIRCLES, Math.min(Tuning.AUTO_TRIAL_CIRCLES, capacity));
        int size = Integer.highestOneBit(2 * circles - 1);
        if (circles <= Tuning.ALONE_CIRCLES) {
            // what is tried is done as the world will be
            size = Math.min(size, Tuning.ALONE_CIRCLES);
        }
        return MADE.computeIfAbsent(new Kind(device, solver, store, size), AutoChoice::tryOut);
    }

    private static AutoChoice tryOut(Kind kind) {
        AutoChoice best = null;
        double least = Double.MAX_VALUE;
        for (AutoChoice candidate : candidates(kind)) {
            double took = seconds(kind, candidate, least);
            LOG.log(System.Logger.Level.DEBUG, "auto: {0} takes {1} ms a step for {2}", candidate, took * 1e3, kind);
            if (best == null || took < least) {
                best = candidate;
                least = took;
            }
        }
        LOG.log(System.Logger.Level.INFO, "auto: {0} for {1}", best, kind);
        return best;
    }

    private static List<AutoChoice> candidates(Kind kind) {
        List<AutoChoice> all = new ArrayList<>();
        boolean triangle = kind.store == CollisionStore.TRIANGLE && kind.solver == Solver.IMPULSE;
        for (IndexStrategy strategy : IndexStrategy.builtIn()) {
            // only pairs have a triangle; without one, beyond some circles only the grid is worth a trial
            if (strategy.pairwise() ? triangle || kind.circles <= Tuning.AUTO_TRIAL_PAIRWISE : !triangle) {
                all.add(new AutoChoice(strategy, Tuning.SMALL_WORLD));
                if (kind.circles <= Tuning.SMALL_WORLD) {
                    all.add(new AutoChoice(strategy, 0));
                }
            }
        }
        return all;
    }

    /** Seconds a step, the least of some; infinite where such a world does not work. Gives up on what is slower than twice {@code best}. */
    private static double seconds(Kind kind, AutoChoice candidate, double best) {
        WorldBuilder builder = new WorldBuilder()
                .device(kind.device)
                .solver(kind.solver)
                .collisionStore(kind.store)
                .indexStrategy(candidate.strategy)
                .smallWorld(candidate.smallWorld)
                .substeps(Tuning.AUTO_FEWEST)
                .capacity(kind.circles);
        double least = Double.MAX_VALUE;
        try (Circles2D world = builder.build()) {
            fill(world, kind.circles);
            world.step();
            world.snapshot();
            for (int round = 0; round < Tuning.AUTO_TRIAL_ROUNDS; round++) {
                long start = System.nanoTime();
                world.step(Tuning.AUTO_TRIAL_STEPS);
                world.snapshot();
                least = Math.min(least, (System.nanoTime() - start) / 1e9 / Tuning.AUTO_TRIAL_STEPS);
                if (least > 2 * best) {
                    break;
                }
            }
            return least;
        } catch (Circles2DException e) {
            LOG.log(System.Logger.Level.DEBUG, "auto: " + candidate + " does not work", e);
            return Double.POSITIVE_INFINITY;
        }
    }

    /** Circles that cover a half of the box and touch here and there, so fast that every step lists its contacts. */
    private static void fill(Circles2D world, int circles) {
        SplittableRandom random = new SplittableRandom(circles);
        int side = (int) Math.ceil(Math.sqrt(circles));
        CircleDef def = new CircleDef();
        for (int i = 0; i < circles; i++) {
            float size = 1f / side;
            def.position(
                    (i % side + 0.5f + (float) random.nextDouble(-0.2, 0.2)) * size,
                    (i / side + 0.5f + (float) random.nextDouble(-0.2, 0.2)) * size);
            def.radius(0.4f * size).mass(1 + (float) random.nextDouble());
            def.velocity(size * (float) random.nextDouble(-8, 8), size * (float) random.nextDouble(-8, 8));
            world.addCircle(def);
        }
    }
}
