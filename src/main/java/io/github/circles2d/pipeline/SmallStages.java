package io.github.circles2d.pipeline;

import java.nio.FloatBuffer;

/**
 * The stages of {@link io.github.circles2d.Solver#SMALL_STEPS} on one device, and the state they work on. {@link
 * SmallPipeline} calls them in order; calls may return before the device is done, save those that say they wait.
 */
public interface SmallStages extends DeviceState {
    /**
     * Replaces the circles; what is remembered of those that were there stays. Waits.
     *
     * @param population the circles
     * @param velocities (vx, vy) a circle, world units a second; direct, native order, read from 0
     * @param levels those that there is to be room for
     * @param used the one of them that is used until {@link #use}
     */
    void upload(Population population, FloatBuffer velocities, Levels[] levels, Levels used);

    /** Which of the levels, one of those uploaded, the detections that follow have their cells from. */
    void use(Levels levels);

    /**
     * Begins a step, with the numbers of its substeps. Allocates nothing.
     *
     * @param ratio of their time to that of those before; what is kept from one to the next is scaled by it
     * @param lists whether there is a detection in it
     */
    void begin(Substeps substeps, float ratio, boolean lists);

    /**
     * Sorts the circles by cell and lists the contacts within reach, with what is remembered of each. Between the moves
     * of one substep and the kicks of the next; a step may go on with the lists of the one before.
     *
     * @param horizon time for which the list must hold, seconds
     * @param slack how much nearer than by their speeds two circles may come in it, and after it in steps that go on with the list, world
     *     units
     */
    void detect(float horizon, float slack);

    /**
     * Some substeps, all but the end of the last: gravity and kicks, contacts; then, for each after the first, the end of the
     * one before, gravity and kicks, contacts. {@link #integrate} or {@link #publish} comes next.
     */
    void solve(int substeps);

    /** The end of a substep, walls and motion, before a detection. */
    void integrate();

    /** Ends a step: the end of its last substep; makes its circles known to {@link #download}, and how they move to {@link #motion}. */
    void publish();

    /** How the circles move after the last step; after {@link #await}. */
    Motion motion();

    /** The status; its updates are the detections done. */
    @Override
    Status await(boolean reading);
}
