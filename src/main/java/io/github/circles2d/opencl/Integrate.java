package io.github.circles2d.opencl;

/** Host code of {@code kernels/integrate.cl}: a substep's share of each circle alone. */
final class Integrate {
    private final Kernel move;
    private final Kernel kick;
    private final Kernel both;
    private final Kernel publish;

    Integrate(Session session, Program program) {
        move = new Kernel(session, program, "c2d_integrate");
        kick = new Kernel(session, program, "c2d_integrate");
        both = new Kernel(session, program, "c2d_integrate");
        publish = new Kernel(session, program, "c2d_publish");
    }

    void bind(SmallWorld world) {
        SmallBuffers buffers = world.buffers();
        Turn now = world.now();
        State state = world.state();
        Object[] circles = {now.body, now.id, buffers.kicked, buffers.walls, buffers.rule, state.status, state.circles};
        move.arguments(circles, 1, 0).range(state.circles, world.group());
        kick.arguments(circles, 0, 1).range(state.circles, world.group());
        both.arguments(circles, 1, 1).range(state.circles, world.group());
        publish.arguments(circles, state.circle, state.velocities, new Kernel.Local(4))
                .range(state.circles, world.group());
    }

    void run(boolean moves, boolean kicks) {
        (moves && kicks ? both : moves ? move : kick).launch();
    }

    void publish() {
        publish.launch();
    }
}
