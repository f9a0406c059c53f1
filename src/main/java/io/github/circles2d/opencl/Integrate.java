package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Motion;

/** Host code of {@code kernels/integrate.cl}: a substep's share of each circle alone. */
final class Integrate {
    /** Local memory of what is found out at the end of a step, bytes. */
    static final int MOST_BYTES = 4 * Motion.NUMBERS;

    private final Kernel load;
    private final Kernel integrate;
    private final Kernel publish;

    Integrate(Session session, Program program) {
        load = new Kernel(session, program, "c2d_load");
        integrate = new Kernel(session, program, "c2d_integrate");
        publish = new Kernel(session, program, "c2d_integrate");
    }

    void bind(SmallWorld world) {
        State state = world.state();
        load.arguments(world.known(), state.circle, state.velocities, state.circles)
                .range(state.circles, world.group());
        bind(integrate, world, 0);
        bind(publish, world, 1);
    }

    private static void bind(Kernel kernel, SmallWorld world, int publishes) {
        State state = world.state();
        kernel.arguments(world.known(), publishes, state.circle, state.velocities, new Kernel.Local(MOST_BYTES))
                .range(state.circles, world.group());
    }

    /** Takes circles from the state that have a place already; of the turn of the last detection. */
    void load() {
        load.launch();
    }

    /** The end of a substep. */
    void run() {
        integrate.launch();
    }

    /** The end of a step. */
    void publish() {
        publish.launch();
    }
}
