package io.github.circles2d.opencl;

/** Host code of {@code kernels/match.cl}: gives each contact what the detection before remembers of it. */
final class Match {
    private final Kernel order;
    private final Kernel match;
    private boolean orders;

    Match(Session session, Program program) {
        order = new Kernel(session, program, "c2d_match_order");
        match = new Kernel(session, program, "c2d_match");
    }

    void bind(SmallWorld world) {
        // by the grid, on one level, find has them in order
        orders = world.config().strategy().pairwise() || world.levels().count > 1;
        Object[] known = world.known();
        order.arguments(known).range(world.contacts(), world.group());
        match.arguments(known).range(world.contacts(), world.group());
    }

    void run() {
        if (orders) {
            order.launch();
        }
        match.launch();
    }
}
