package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Speeds;

/** Host code of {@code kernels/integrate.cl}: a substep's share of each circle alone. */
final class Integrate {
    private final Kernel integrate;
    private final Kernel publish;

    Integrate(Session session, Program program) {
        integrate = new Kernel(session, program, "c2d_integrate");
        publish = new Kernel(session, program, "c2d_publish");
    }

    void bind(SmallWorld world) {
        State state = world.state();
        integrate.arguments(world.known()).range(state.circles, world.group());
        int ranges = Speeds.ranges(state.circles) ? State.RANGES : 0;
        publish.arguments(world.known(), state.circle, state.velocities, ranges, new Kernel.Local(4 + 4 * State.RANGES))
                .range(state.circles, world.group());
    }

    /** The end of a substep. */
    void run() {
        integrate.launch();
    }

    void publish() {
        publish.launch();
    }
}
