package io.github.circles2d;

import io.github.circles2d.pipeline.BackgroundSteps;
import io.github.circles2d.pipeline.DeviceState;
import io.github.circles2d.pipeline.Meanwhile;
import io.github.circles2d.pipeline.Pipeline;
import io.github.circles2d.pipeline.SmallPipeline;
import io.github.circles2d.pipeline.SmallStages;
import io.github.circles2d.pipeline.Stages;
import io.github.circles2d.pipeline.StepSums;
import io.github.circles2d.pipeline.Stepper;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.FloatBuffer;

/** What a world holds: its circles on the host and on the device, which of them are newer, and who makes the steps. Not thread-safe. */
final class WorldState {
    private static final System.Logger LOG = System.getLogger(Circles2D.class.getName());

    private final CircleState circles;
    private final DeviceState stages;
    private final Stepper stepper;
    /** Null where steps are made in the thread that calls. */
    private final BackgroundSteps background;

    /** The state on the host is that of the last step. */
    private boolean fresh = true;
    /** The state on the host has changes that the device has not seen, nor has the thread that makes the steps been told of them. */
    private boolean changed = true;

    /** Changes have been sent for a step that has not been asked for yet: whoever sends more names these again. */
    private boolean sentAhead;
    /** How many circles the device holds. */
    private int sent = -1;
    /** An upload has failed half-way: what the device holds is neither the old state nor the new. */
    private boolean lost;

    private long steps;
    /** Of step number {@code stats.steps()}. */
    private StepStats stats = new StepStats(0, 0, 0, 0, 0, 0, 0, 0, 0);

    private Throwable failure;

    WorldState(ComputeDevice device, WorldConfig config, int capacity, boolean inBackground) {
        // Java clears them first: of a million that takes longer than a step
        Meanwhile<CircleState> buffers =
                new Meanwhile<>(capacity >= Tuning.COPY_CIRCLES, () -> new CircleState(capacity, inBackground));
        if (config.solver() == Solver.SMALL_STEPS) {
            SmallStages small = device.device().openSmall(config);
            stages = small;
            stepper = new SmallPipeline(config, small);
        } else {
            Stages opened = device.device().open(config);
            stages = opened;
            stepper = new Pipeline(opened);
        }
        try {
            circles = buffers.get();
            background = inBackground ? new BackgroundSteps(stepper, stages) : null;
        } catch (RuntimeException | Error e) {
            stages.close();
            throw e;
        }
    }

    /** @throws Circles2DException if the world has failed: the failure itself where nobody has seen it yet */
    void requireUsable() {
        if (failure != null) {
            throw new Circles2DException("this world has failed: " + failure.getMessage(), failure);
        }
        if (background != null && background.failure() != null) {
            failure = background.failure();
            if (failure instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) failure;
        }
    }

    private Circles2DException failed(Circles2DException e) {
        failure = e;
        return e;
    }

    /** Waits for the steps in the background. */
    private void settle() {
        if (background != null) {
            background.await();
            requireUsable();
        }
    }

    /** The circles as the host had them last; their number is always right. */
    CircleState circles() {
        return circles;
    }

    /** The circles after the last step. */
    CircleState latest() {
        if (fresh) {
            return circles;
        }
        if (background != null) {
            settle();
            background.target(circles.swap());
        } else {
            try {
                stepper.await();
                stages.download(circles.shown().transforms(), circles.shown().velocities());
            } catch (Circles2DException e) {
                throw failed(e);
            }
        }
        fresh = true;
        return circles;
    }

    /** The same to write to. */
    CircleState toChange() {
        latest();
        changed = true;
        return circles;
    }

    void step(int count) {
        if (background != null && changed && !allAreNew()) {
            // nobody changes them, or shows others, before that step is done
            background.velocities(circles.shown().velocities(), circles.changes());
            changed = false;
        } else {
            upload();
            if (sentAhead) {
                circles.changes().clear();
            }
        }
        sentAhead = false;
        fresh = false;
        if (background != null) {
            background.step(count);
        } else {
            try {
                for (int i = 0; i < count; i++) {
                    stepper.step();
                }
            } catch (Circles2DException e) {
                throw failed(e);
            }
        }
        steps += count;
    }

    /** The device has other circles, or nobody knows what it has. */
    private boolean allAreNew() {
        return lost || sent != circles.count();
    }

    private void upload() {
        if (!changed) {
            return;
        }
        settle();
        boolean all = allAreNew();
        if (background != null && all) {
            background.target(circles.reserveHidden());
        }
        FloatBuffer velocities = circles.shown().velocities();
        lost = true;
        if (all) {
            stepper.upload(circles.population(), velocities, circles.changes());
        } else {
            stepper.velocities(velocities, circles.changes());
        }
        lost = false;
        sent = circles.count();
        sentAhead = true;
        changed = false;
    }

    StepStats stats() {
        if (steps > 0 && stats.steps() == steps) {
            return stats;
        }
        if (steps == 0 || lost) {
            upload();
        }
        settle();
        try {
            stepper.await();
            StepSums sums = stages.sums();
            stats = new StepStats(
                    steps,
                    sums.touching(),
                    sums.largestOverlap(),
                    sums.meanOverlap(),
                    sums.energy(),
                    sums.momentumX(),
                    sums.momentumY(),
                    sums.fastest(),
                    (int) sums.outside());
            return stats;
        } catch (Circles2DException e) {
            throw failed(e);
        }
    }

    long bytes() {
        settle();
        return stages.bytes();
    }

    /** Ends what goes on in the background, releases nothing: for a world that nobody has any more. */
    void abandon() {
        if (background != null) {
            background.stop();
        }
    }

    void close() {
        if (background != null) {
            background.end();
            if (failure == null && background.failure() != null) {
                LOG.log(System.Logger.Level.WARNING, "a step failed, and the world was closed", background.failure());
            }
        }
        stages.close();
    }
}
