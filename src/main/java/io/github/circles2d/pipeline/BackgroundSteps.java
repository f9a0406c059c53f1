package io.github.circles2d.pipeline;

import java.nio.FloatBuffer;
import java.util.concurrent.locks.LockSupport;

/**
 * Makes the steps of one world on a thread of its own, and reads the circles back when those asked for are done. For one caller at a
 * time; what the caller and the thread share changes hands with {@link #asked} and {@link #done}. Must hold nothing that holds the
 * world: a world that nobody has any more is found by the collector while the thread is there.
 */
public final class BackgroundSteps {
    private final Stepper stepper;
    private final DeviceState stages;
    private final Thread thread;
    /** Steps since the world was built; only the caller writes it. */
    private volatile long asked;
    /** Steps that are done and read back; only the thread writes it. */
    private volatile long done;

    private volatile boolean ending;
    private volatile Throwable failure;
    private volatile Thread waiting;
    private CircleBuffers target;
    /** Velocities to send before the next step, or null, and whose they are. */
    private FloatBuffer velocities;

    private Changes changed;

    /** Starts the thread. */
    public BackgroundSteps(Stepper stepper, DeviceState stages) {
        this.stepper = stepper;
        this.stages = stages;
        // of what the caller's thread inherits nothing is needed, and it would be held as long as the world
        thread = new Thread(null, this::run, "circles2d steps", 0, false);
        thread.setDaemon(true);
        thread.start();
    }

    /** What to read the circles into from now on; with no step under way. */
    public void target(CircleBuffers newTarget) {
        target = newTarget;
    }

    /**
     * Velocities that the next step is to begin with; with no step under way. They and what says whose they are must stay as they are
     * until that step is done; then none of them has changed any more.
     */
    public void velocities(FloatBuffer newVelocities, Changes whose) {
        velocities = newVelocities;
        changed = whose;
    }

    /** Asks for steps; returns at once and allocates nothing. */
    public void step(int count) {
        asked = asked + count;
        LockSupport.unpark(thread);
    }

    /** Waits, through interrupts, until every step asked for is done and read back, or none will be any more. */
    public void await() {
        boolean interrupted = false;
        waiting = Thread.currentThread();
        while (done != asked && failure == null) {
            LockSupport.park(this);
            interrupted |= Thread.interrupted();
        }
        waiting = null;
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** What a step has thrown, or null. No step is made after it. */
    public Throwable failure() {
        return failure;
    }

    /** Tells the thread to end after the step that is under way; those that have not begun are dropped. */
    public void stop() {
        ending = true;
        LockSupport.unpark(thread);
    }

    /** As {@link #stop}, and waits, through interrupts, until it has. */
    public void end() {
        stop();
        boolean interrupted = false;
        while (thread.isAlive()) {
            try {
                thread.join();
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private void send() {
        if (velocities != null) {
            stepper.velocities(velocities, changed);
            changed.clear();
            velocities = null;
        }
    }

    private void run() {
        try {
            long made = 0;
            while (!ending) {
                if (made < asked) {
                    send();
                    stepper.step();
                    made++;
                } else if (done < made) {
                    stepper.await();
                    stages.download(target.transforms(), target.velocities());
                    done = made;
                    LockSupport.unpark(waiting);
                } else {
                    LockSupport.park(this);
                }
            }
        } catch (Throwable e) {
            failure = e;
            LockSupport.unpark(waiting);
        }
    }
}
