package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.Tuning;
import java.util.ArrayList;
import java.util.List;

/** Host code of {@code kernels/batch.cl}: puts the contacts in the order in which they are solved. */
final class Batch {
    /** Bytes of {@code counts}. */
    static final long COUNTS = 4 * (64 + 2);

    private final Session session;
    private final Program program;
    private final Kernel count;
    private final Scan scan;
    private final Kernel fill;
    private final List<Kernel> colours = new ArrayList<>();
    private final Kernel few;
    private final Kernel order;
    private int launches;
    private boolean hasFew;

    Batch(Session session, Program program) {
        this.session = session;
        this.program = program;
        count = new Kernel(session, program, "c2d_batch_count");
        scan = new Scan(session, program);
        fill = new Kernel(session, program, "c2d_batch_fill");
        few = new Kernel(session, program, "c2d_batch_colour_few");
        order = new Kernel(session, program, "c2d_batch_order");
    }

    /**
     * What every kernel that colours begins with, {@code C2D_BATCH_COLOUR}.
     *
     * @param firstTiles tiles of the first tiling
     */
    static Object[] contacts(SmallWorld world, int firstTiles) {
        SmallBuffers buffers = world.buffers();
        Turn now = world.now();
        Turn free = world.before();
        return new Object[] {
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
            Tiles.PARTS * firstTiles
        };
    }

    void bind(SmallWorld world) {
        SmallBuffers buffers = world.buffers();
        Turn now = world.now();
        Turn free = world.before();
        DeviceBuffer status = world.state().status;
        int capacity = buffers.capacity();
        Tiles tiles = world.tiles();
        int fused = world.fused() ? 1 : 0;
        Object[] known = {
            now.body, buffers.levels, buffers.tilings, buffers.rule, status, world.circles(), now.listStart
        };
        count.arguments(known, now.other, capacity, tiles.tiles, fused, free.body, buffers.tileStart, buffers.from)
                .range(world.contacts(), world.group());
        scan.bind(world, buffers.tileStart, (world.fused() ? tiles.parts() : Tiles.PARTS * tiles.tiles) + 1, -1);
        fill.arguments(
                        known,
                        capacity,
                        tiles.tiles,
                        fused,
                        free.body,
                        buffers.tileStart,
                        buffers.from,
                        free.other,
                        free.id,
                        buffers.kicked)
                .range(world.contacts(), world.group());
        Levels levels = world.levels();
        Object[] contacts = contacts(world, tiles.first(1));
        int wide = world.config().smallWorld() > 0 ? wideLevels(levels) : levels.count;
        launches = 0;
        for (int level = 0; level < wide; level++) {
            bindLevel(world, contacts, level);
        }
        hasFew = wide < levels.count;
        few.arguments(contacts, wide, levels.count).range(1, world.oneGroup());
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
                        tiles.first(1),
                        tiles.tiles,
                        fused,
                        free.id,
                        buffers.from,
                        new Kernel.Local(COUNTS))
                .groups(tiles.tiles, world.tileGroup());
    }

    private void bindLevel(SmallWorld world, Object[] contacts, int level) {
        int rows = Levels.rows(level);
        for (int which = 0; which < 3 * rows; which++) {
            int x = which % 3;
            int y = which / 3;
            int across = across(world.levels(), level, x);
            int buckets = across * up(world.levels(), level, y);
            if (launches == colours.size()) {
                colours.add(new Kernel(session, program, "c2d_batch_colour"));
            }
            colours.get(launches++)
                    .arguments(contacts, level, x, y, rows, across, buckets)
                    .range(buckets, Math.min(world.group(), Tuning.COLOUR_WORK_GROUP));
        }
    }

    /** Buckets of one colour in a row. */
    private static int across(Levels levels, int level, int x) {
        return (levels.table[Levels.at(level) + Levels.WIDTH] - x + 2) / 3;
    }

    /** Rows with buckets of one colour. */
    private static int up(Levels levels, int level, int y) {
        int rows = Levels.rows(level);
        return (levels.table[Levels.at(level) + Levels.HEIGHT] - y + rows - 1) / rows;
    }

    /** Levels up to the last that is worth launches of its own. */
    private static int wideLevels(Levels levels) {
        int wide = levels.count;
        while (wide > 0 && across(levels, wide - 1, 0) * up(levels, wide - 1, 0) <= Tuning.NARROW) {
            wide--;
        }
        return wide;
    }

    void run() {
        count.launch();
        scan.run();
        fill.launch();
        for (int k = 0; k < launches; k++) {
            colours.get(k).launch();
        }
        if (hasFew) {
            few.launch();
        }
        order.launch();
    }
}
