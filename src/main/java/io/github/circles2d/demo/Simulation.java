package io.github.circles2d.demo;

import io.github.circles2d.Circles2D;
import io.github.circles2d.Circles2DException;
import java.util.function.Consumer;

/**
 * The worlds behind a window, in real time. {@link #run} belongs to one thread, and the worlds with it; every other
 * method may be called from any thread and returns at once.
 */
final class Simulation {
    private static final long STEP_NANOS = 1_000_000_000L / 60;
    /** Steps that a late frame makes up for; more time than that is dropped. */
    private static final int MOST_STEPS = 3;

    private static final long REPORT_NANOS = 500_000_000L;

    /**
     * What the window shows.
     *
     * @param millis of a step and its snapshot, lately; 0 before it is known
     * @param contacts of a step lately
     * @param message what there is to say instead of numbers, or empty
     * @param failed the message is about a failure
     */
    record View(Frame frame, Setup setup, long steps, double millis, long contacts, String message, boolean failed) {}

    private final int limit;
    private final Consumer<View> viewer;

    private Setup setup;
    private boolean restart;
    private boolean paused;
    private boolean closed;
    private int singles;

    /** Real time that no step has used up yet, nanoseconds, as of {@link #time}. */
    private long owed;

    private long time;
    private double millis;
    private long contacts;

    /**
     * @param limit steps after which it ends; 0 for never
     * @param viewer called in the simulation's thread after each frame
     */
    Simulation(Setup setup, int limit, Consumer<View> viewer) {
        this.setup = setup;
        this.limit = limit;
        this.viewer = viewer;
    }

    /** Starts again with another world. */
    synchronized void restart(Setup with) {
        setup = with;
        restart = true;
        singles = 0;
        notifyAll();
    }

    synchronized void pause(boolean pause) {
        paused = pause;
        notifyAll();
    }

    /** One step of a paused world. */
    synchronized void single() {
        singles++;
        notifyAll();
    }

    synchronized void close() {
        closed = true;
        notifyAll();
    }

    /** Runs until it is closed, or the limit is reached, or, where there is a limit, the device fails. True if it reached it. */
    boolean run() throws InterruptedException {
        for (Setup now = next(); now != null; now = next()) {
            view(Frame.EMPTY, now, 0, "starting on " + now.device().name() + " ...", false);
            try (Circles2D world = now.build()) {
                if (run(world, now)) {
                    return true;
                }
            } catch (Circles2DException | OutOfMemoryError e) {
                view(Frame.EMPTY, now, 0, Demo.describe(e), true);
                if (limit > 0) {
                    return false;
                }
                awaitChange();
            }
        }
        return false;
    }

    private synchronized Setup next() {
        restart = false;
        return closed ? null : setup;
    }

    private synchronized void awaitChange() throws InterruptedException {
        while (!restart && !closed) {
            wait();
        }
    }

    /** Steps a world until something changes or the limit is reached; true for the limit. */
    private boolean run(Circles2D world, Setup now) throws InterruptedException {
        millis = 0;
        contacts = 0;
        view(Frame.of(world.snapshot()), now, 0, "", false);
        time = System.nanoTime();
        owed = 0;
        long reported = time;
        long busy = 0;
        int counted = 0;
        long steps = 0;
        for (int due = awaitSteps(); due > 0; due = awaitSteps()) {
            due = limit > 0 ? (int) Math.min(due, limit - steps) : due;
            long start = System.nanoTime();
            world.step(due);
            Frame frame = Frame.of(world.snapshot());
            long end = System.nanoTime();
            steps += due;
            counted += due;
            busy += end - start;
            if (end - start > due * STEP_NANOS) {
                // slower than real time: catching up would only make the frames rarer
                owed = 0;
                time = end;
            }
            if (end - reported >= REPORT_NANOS) {
                millis = busy / 1e6 / counted;
                contacts = world.stats().contacts();
                reported = end;
                busy = 0;
                counted = 0;
            }
            view(frame, now, steps, "", false);
            if (steps == limit) {
                return true;
            }
        }
        return false;
    }

    /** Waits until steps are due and says how many; 0 for a restart or the end. */
    private synchronized int awaitSteps() throws InterruptedException {
        while (!restart && !closed) {
            long before = time;
            time = System.nanoTime();
            if (paused) {
                owed = 0;
                if (singles > 0) {
                    singles--;
                    return 1;
                }
                wait();
            } else {
                singles = 0;
                owed = Math.min(owed + time - before, MOST_STEPS * STEP_NANOS);
                int due = (int) (owed / STEP_NANOS);
                if (due > 0) {
                    owed -= due * STEP_NANOS;
                    return due;
                }
                wait(Math.max(1, (STEP_NANOS - owed) / 1_000_000));
            }
        }
        return 0;
    }

    private void view(Frame frame, Setup of, long steps, String message, boolean failed) {
        viewer.accept(new View(frame, of, steps, millis, contacts, message, failed));
    }
}
