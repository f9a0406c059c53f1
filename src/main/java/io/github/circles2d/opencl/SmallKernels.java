package io.github.circles2d.opencl;

/** The stages of small steps for one of the two turns, bound to its buffers. */
final class SmallKernels {
    final Grid grid;
    final Find find;
    final Match match;
    final Integrate integrate;
    final Solve solve;

    /** Whether the arguments are those of the buffers as they are now. */
    boolean bound;

    SmallKernels(Session session, Program program, PairTables tables) {
        grid = new Grid(session, program);
        find = new Find(session, program, tables);
        match = new Match(session, program);
        integrate = new Integrate(session, program);
        solve = new Solve(session, program);
    }
}
