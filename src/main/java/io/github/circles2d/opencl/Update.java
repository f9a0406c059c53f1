package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.CellGrid;
import io.github.circles2d.pipeline.WorldConfig;

/** Host code of {@code kernels/update.cl}: moves every circle through one time step and off the walls. */
final class Update {
    private final Kernel update;

    Update(Session session, Program program) {
        update = new Kernel(session, program, "c2d_update");
    }

    void bind(WorldConfig config, State state, Contacts contacts, CellGrid cells, int group) {
        update.arguments(
                        state.circle,
                        state.velocities,
                        contacts.cellStart,
                        state.status,
                        state.circles,
                        cells.cells(),
                        config.timeStep(),
                        new float[] {config.velocityGainX(), config.velocityGainY()},
                        new float[] {config.fallX(), config.fallY()},
                        new float[] {config.minX(), config.minY(), config.maxX(), config.maxY()},
                        config.restitution())
                .range(Math.max(state.circles, cells.cells()), group);
    }

    void run() {
        update.launch();
    }
}
