package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.Tuning;
import java.util.ArrayList;
import java.util.List;

/** Host code of {@code kernels/batch.cl}: puts the contacts in the order in which they are solved. */
final class Batch {
    /** Bytes of {@code counts}. */
    private static final long COUNTS = 4 * (64 + 2);

    private final Session session;
    private final Program program;
    private final Kernel count;
    private final Scan scan;
    private final Kernel fill;
    private final List<Kernel> colours = new ArrayList<>();
    private final Kernel order;
    private int launches;

    Batch(Session session, Program program) {
        this.session = session;
        this.program = program;
        count = new Kernel(session, program, "c2d_batch_count");
        scan = new Scan(session, program);
        fill = new Kernel(session, program, "c2d_batch_fill");
        order = new Kernel(session, program, "c2d_batch_order");
    }

    void bind(SmallWorld world) {
        SmallBuffers buffers = world.buffers();
        Turn now = world.now();
        Turn free = world.before();
        DeviceBuffer status = world.state().status;
        int capacity = buffers.capacity();
        Tiles tiles = world.tiles();
        Object[] known = {
            now.body, buffers.levels, buffers.tilings, buffers.rule, status, world.circles(), now.listStart
        };
        count.arguments(known, now.other, capacity, tiles.tiles, free.body, buffers.tileStart, buffers.from)
                .range(world.contacts(), world.group());
        scan.bind(world, buffers.tileStart, tiles.parts() + 1, -1);
        fill.arguments(
                        known,
                        capacity,
                        tiles.tiles,
                        free.body,
                        buffers.tileStart,
                        buffers.from,
                        free.other,
                        free.id,
                        buffers.kicked)
                .range(world.contacts(), world.group());
        launches = 0;
        for (int level = 0; level < world.levels().count; level++) {
            bindLevel(world, level);
        }
        order.arguments(
                        now.other,
                        free.other,
                        free.listStart,
                        capacity,
                        free.body,
                        free.memory,
                        buffers.tileStart,
                        buffers.tileColours,
                        status,
                        new Kernel.Local(COUNTS))
                .groups(tiles.tiles, world.tileGroup());
    }

    private void bindLevel(SmallWorld world, int level) {
        SmallBuffers buffers = world.buffers();
        Turn now = world.now();
        Turn free = world.before();
        Levels levels = world.levels();
        int rows = Levels.rows(level);
        for (int which = 0; which < 3 * rows; which++) {
            int x = which % 3;
            int y = which / 3;
            int across = (levels.table[Levels.at(level) + Levels.WIDTH] - x + 2) / 3;
            int buckets = across * ((levels.table[Levels.at(level) + Levels.HEIGHT] - y + rows - 1) / rows);
            if (launches == colours.size()) {
                colours.add(new Kernel(session, program, "c2d_batch_colour"));
            }
            colours.get(launches++)
                    .arguments(
                            now.listStart,
                            now.other,
                            buffers.bucketStart,
                            buffers.levels,
                            world.state().status,
                            buffers.capacity(),
                            free.body,
                            buffers.kicked,
                            buffers.from,
                            free.listStart,
                            Tiles.PARTS * world.tiles().first(1),
                            level,
                            x,
                            y,
                            rows,
                            across,
                            buckets)
                    .range(buckets, Math.min(world.group(), Tuning.COLOUR_WORK_GROUP));
        }
    }

    void run() {
        count.launch();
        scan.run();
        fill.launch();
        for (int k = 0; k < launches; k++) {
            colours.get(k).launch();
        }
        order.launch();
    }
}
