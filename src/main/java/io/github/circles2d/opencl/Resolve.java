package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.CellGrid;
import io.github.circles2d.pipeline.WorldConfig;

/** Host code of {@code kernels/resolve.cl}: parts circles and exchanges impulses, a colour at a time. */
final class Resolve {
    private final Kernel[] colours = new Kernel[CellGrid.COLOURS];
    private final Kernel small;

    Resolve(Session session, Program program) {
        for (int colour = 0; colour < colours.length; colour++) {
            colours[colour] = new Kernel(session, program, "c2d_resolve");
        }
        small = new Kernel(session, program, "c2d_resolve_small");
    }

    void bind(WorldConfig config, State state, Contacts contacts, CellGrid cells, int group, int oneGroup) {
        float[] bounds = {config.minX(), config.minY(), config.maxX(), config.maxY()};
        for (int colour = 0; colour < colours.length; colour++) {
            colours[colour]
                    .arguments(
                            state.circle,
                            state.velocities,
                            contacts.contact,
                            contacts.cellStart,
                            state.status,
                            bounds,
                            cells.columns(),
                            cells.rows(),
                            colour)
                    .range(cells.owners(colour), group);
        }
        small.arguments(
                        state.circle,
                        new float[] {cells.minX(), cells.minY()},
                        cells.perUnit(),
                        cells.columns(),
                        cells.rows(),
                        contacts.found,
                        contacts.cellStart,
                        contacts.byCell,
                        contacts.contact,
                        state.velocities,
                        state.status,
                        contacts.capacity(),
                        bounds,
                        config.restitution(),
                        new Kernel.Local(4L * oneGroup))
                .range(1, oneGroup);
    }

    void run() {
        for (Kernel colour : colours) {
            colour.launch();
        }
    }

    /** Colours and resolves, in one launch of one work-group. */
    void runSmall() {
        small.launch();
    }
}
