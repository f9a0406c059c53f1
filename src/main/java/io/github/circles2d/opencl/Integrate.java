package io.github.circles2d.opencl;

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
        Object[] known = world.known();
        integrate.arguments(known).range(state.circles, world.group());
        publish.arguments(known, state.circle, state.velocities, new Kernel.Local(4))
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
