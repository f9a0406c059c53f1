package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.Tuning;

/** Host code of {@code kernels/persistent.cl}: a detection and the substeps that follow it in one launch. */
final class Persistent {
    /** Numbers of {@code C2D_COUNTS} and what a group has besides, ints. */
    private static final int COUNTS = 64 + 2;

    private final Kernel kernel;
    private final int[] how = new int[8];

    Persistent(Session session, Program program) {
        kernel = new Kernel(session, program, "c2d_persistent");
    }

    void bind(SmallWorld world) {
        SmallBuffers buffers = world.buffers();
        State state = world.state();
        Turn now = world.now();
        Turn before = world.before();
        Tiles tiles = world.tiles();
        kernel.groups(world.persistentGroups(), world.persistentGroup());
        int teams = Math.max(1, kernel.group() / Tuning.GPU_TILE_GROUP);
        Object[] circles = {now.body, now.id, buffers.kicked, buffers.walls, buffers.rule, before.body, before.id};
        Object[] cells = {
            buffers.levels,
            buffers.tilings,
            state.status,
            state.circles,
            world.levels().cells,
            tiles.parts(),
            buffers.bucketStart
        };
        // sorting uses what kicks come to, and colouring what places were
        Object[] lists = {
            buffers.kicked,
            buffers.from,
            now.listStart,
            now.other,
            now.memory,
            before.listStart,
            before.other,
            before.memory
        };
        Object[] order = {
            buffers.capacity(),
            before.body,
            buffers.tileStart,
            buffers.tileColours,
            tiles.tiles,
            tiles.tilings,
            before.id,
            before.other,
            before.memory,
            before.listStart,
            buffers.kicked
        };
        kernel.arguments(
                circles,
                cells,
                lists,
                order,
                buffers.partSums,
                state.circle,
                state.velocities,
                buffers.meeting,
                new Kernel.Local(4L * (Math.max(kernel.group(), teams * COUNTS) + 1)));
    }

    /** As {@link io.github.circles2d.pipeline.SmallStages#advance} says; {@code launch} differs from that of the launch before. */
    void run(int launch, boolean moves, float horizon, float fall, int substeps, boolean last) {
        how[0] = launch;
        how[1] = moves ? 1 : 0;
        how[2] = substeps;
        how[3] = last ? 1 : 0;
        how[4] = Float.floatToRawIntBits(horizon);
        how[5] = Float.floatToRawIntBits(fall);
        kernel.more(how);
        kernel.launch();
    }
}
