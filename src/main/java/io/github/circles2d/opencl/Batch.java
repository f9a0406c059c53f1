package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.Tuning;
import java.util.ArrayList;
import java.util.List;

/** Host code of {@code kernels/batch.cl}: puts the contacts in the order in which they are solved. */
final class Batch {
    /** Bytes of {@code counts}. */
    static final long COUNTS = 4 * (64 + 2);

    /** {@code C2D_BINS}. */
    static final int BINS = 64;

    /** {@code C2D_ROWS}. */
    private static final int ROWS = 256;

    private final Session session;
    private final Program program;
    private final Kernel count;
    private final Scan scan;
    private final Kernel fill;
    /** One a tiling. */
    private final List<Kernel> colours = new ArrayList<>();

    private final Kernel order;
    private int tilings;

    Batch(Session session, Program program) {
        this.session = session;
        this.program = program;
        count = new Kernel(session, program, "c2d_batch_count");
        scan = new Scan(session, program);
        fill = new Kernel(session, program, "c2d_batch_fill");
        order = new Kernel(session, program, "c2d_batch_order");
    }

    void bind(SmallWorld world) {
        Object[] known = world.known();
        Tiles tiles = world.tiles();
        count.arguments(known, tiles.tiles).range(world.contacts() / 2 + 1, world.group());
        scan.bind(world, Heap.TILE_START, tiles.parts() + 1, false);
        fill.arguments(known, tiles.tiles, tiles.tilings).range(world.contacts(), world.group());
        tilings = tiles.tilings;
        for (int tiling = 0; tiling < tilings; tiling++) {
            if (tiling == colours.size()) {
                colours.add(new Kernel(session, program, "c2d_batch_colour"));
            }
            boolean first = tiling == 0;
            int most = !world.asOnGpu() ? 0 : first ? Tuning.TILE_CONTACTS : Tuning.OTHER_TILE_CONTACTS;
            int circles = Integer.highestOneBit(first ? most : 2 * most);
            colours.get(tiling)
                    .arguments(known, tiling, tiles.tiles, local(most, circles, true))
                    .groups(tiles.count(tiling), first ? world.colourGroup() : world.tileGroup());
        }
        order.arguments(known, tiles.tiles, tilings, new Kernel.Local(COUNTS))
                .groups(tiles.tiles, world.firstTileGroup());
    }

    /** What tiles of up to so many contacts and circles are coloured in: {@code C2D_LOCAL}. */
    static Object[] local(int contacts, int circles, boolean hashed) {
        return new Object[] {
            contacts,
            circles,
            new Kernel.Local(4L * Math.max(1, circles)),
            new Kernel.Local(4L * Math.max(1, hashed ? circles : 0)),
            new Kernel.Local(8L * Math.max(1, contacts)),
            new Kernel.Local(2L * Math.max(2, contacts)),
            new Kernel.Local(2L * Math.max(2, hashed ? Math.min(contacts, ROWS) : contacts)),
            new Kernel.Local(4L * (2 * BINS + 1)),
            new Kernel.Local(4)
        };
    }

    /** @param groups for so many tiles of a tiling */
    void run(int groups) {
        count.launch();
        scan.run();
        fill.launch();
        for (int tiling = 0; tiling < tilings; tiling++) {
            colours.get(tiling).launch(groups);
        }
        order.launch((long) groups * tilings);
    }
}
