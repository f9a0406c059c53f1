package io.github.circles2d.pipeline;

import java.nio.FloatBuffer;

/**
 * Calls the stages of a step in order: update, detect, colour, resolve; the same for every device.
 *
 * <p>Steps queue up on the device. One that finds more contacts than there is room for stalls: it and all later ones
 * leave the state alone until {@link #await()} has made room and taken the stalled step up again, from detect on. So
 * no contact is ever dropped, and no step needs to wait.
 */
public final class Pipeline implements Stepper {
    private final Stages stages;
    private int inFlight;
    private long contacts;

    public Pipeline(Stages stages) {
        this.stages = stages;
    }

    @Override
    public void upload(Population population, FloatBuffer velocities, Changes changed) {
        stages.upload(population, velocities);
    }

    @Override
    public void velocities(FloatBuffer velocities, Changes changed) {
        stages.velocities(velocities, changed);
    }

    /** Queues one step; waits only when {@link Tuning#STEPS_IN_FLIGHT} are queued. */
    @Override
    public void step() {
        stages.update();
        collide();
        if (++inFlight >= Tuning.STEPS_IN_FLIGHT) {
            await(false);
        }
    }

    private void collide() {
        stages.detect();
        stages.colour();
        stages.resolve();
    }

    /** Waits until every queued step is done, growing the room for contacts where one needs it. */
    @Override
    public void await() {
        await(true);
    }

    private void await(boolean reading) {
        if (inFlight == 0) {
            return;
        }
        Status status = stages.await(reading);
        while (status.stalled()) {
            int left = inFlight - status.updates();
            stages.makeRoom(status.contacts());
            collide();
            inFlight = left;
            for (int i = 0; i < left; i++) {
                stages.update();
                collide();
            }
            status = stages.await(reading);
        }
        contacts = status.contacts();
        inFlight = 0;
    }

    /** Contacts of the last step that {@link #await()} saw. */
    @Override
    public long contacts() {
        return contacts;
    }
}
