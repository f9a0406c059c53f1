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

    void bind(SmallWorld world) {
        Object[] known = world.known();
        Tiles tiles = world.tiles();
        count.arguments(known, tiles.tiles).range(world.contacts() / 2 + 1, world.group());
        scan.bind(world, Heap.TILE_START, tiles.parts() + 1, false);
        fill.arguments(known, tiles.tiles).range(world.contacts(), world.group());
        Levels levels = world.levels();
        int wide = world.config().smallWorld() > 0 ? wideLevels(levels) : levels.count;
        launches = 0;
        for (int level = 0; level < wide; level++) {
            bindLevel(world, known, level);
        }
        hasFew = wide < levels.count;
        few.arguments(known, others(tiles), wide, levels.count).range(1, world.oneGroup());
        order.arguments(known, tiles.first(1), tiles.tiles, new Kernel.Local(COUNTS))
                .groups(tiles.tiles, world.firstTileGroup());
    }

    /** The first part of the tiles of the second tiling. */
    private static int others(Tiles tiles) {
        return Tiles.PARTS * tiles.first(1);
    }

    private void bindLevel(SmallWorld world, Object[] known, int level) {
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
                    .arguments(known, others(world.tiles()), level, x, y, rows, across, buckets)
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
