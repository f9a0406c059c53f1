package io.github.circles2d.opencl;

import java.util.ArrayList;
import java.util.List;

/** Host code of {@code kernels/batch.cl}: puts the contacts in the order in which they are solved. */
final class Batch {
    /** Bytes of {@code shared}. */
    private static final long SHARED = 4 * (32 + 3 + 1);

    private final Session session;
    private final Program program;
    private final Kernel count;
    private final Scan scan;
    private final Kernel fill;
    private final List<Kernel> colour = new ArrayList<>();
    private int tilings;

    Batch(Session session, Program program) {
        this.session = session;
        this.program = program;
        count = new Kernel(session, program, "c2d_batch_count");
        scan = new Scan(session, program);
        fill = new Kernel(session, program, "c2d_batch_fill");
    }

    void bind(SmallWorld world) {
        SmallBuffers buffers = world.buffers();
        Turn now = world.now();
        Turn free = world.before();
        DeviceBuffer status = world.state().status;
        int capacity = buffers.capacity();
        int tiles = world.tiles().tiles;
        Object[] known = {
            now.body, buffers.levels, buffers.tilings, buffers.rule, status, world.circles(), now.listStart
        };
        count.arguments(known, now.other, capacity, tiles, free.body, buffers.tileStart, buffers.kicked)
                .range(world.contacts(), world.group());
        scan.bind(world, buffers.tileStart, world.tiles().parts() + 1, -1);
        fill.arguments(
                        known,
                        capacity,
                        tiles,
                        free.body,
                        buffers.tileStart,
                        buffers.kicked,
                        free.other,
                        free.listStart,
                        free.id)
                .range(world.contacts(), world.group());
        tilings = world.tiles().tilings;
        for (int tiling = 0; tiling < tilings; tiling++) {
            if (tiling == colour.size()) {
                colour.add(new Kernel(session, program, "c2d_batch_colour"));
            }
            colour.get(tiling)
                    .arguments(
                            now.other,
                            free.other,
                            free.listStart,
                            world.circles(),
                            capacity,
                            free.body,
                            free.memory,
                            buffers.kicked,
                            buffers.from,
                            buffers.tileStart,
                            buffers.tileColours,
                            status,
                            world.tiles().first(tiling),
                            new Kernel.Local(SHARED))
                    .groups(world.tiles().count(tiling), world.tileGroup());
        }
    }

    void run() {
        count.launch();
        scan.run();
        fill.launch();
        for (int tiling = 0; tiling < tilings; tiling++) {
            colour.get(tiling).launch();
        }
    }
}
