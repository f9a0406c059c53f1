package io.github.circles2d.opencl;

/** Host code of {@code kernels/grid.cl}: sorts the circles by bucket, and by number within each. */
final class Grid {
    private final Kernel clear;
    private final Kernel bin;
    private final Scan scan;
    private final Kernel scatter;
    private final Kernel order;

    Grid(Session session, Program program) {
        clear = new Kernel(session, program, "c2d_grid_clear");
        bin = new Kernel(session, program, "c2d_grid_bin");
        scan = new Scan(session, program);
        scatter = new Kernel(session, program, "c2d_grid_scatter");
        order = new Kernel(session, program, "c2d_grid_order");
    }

    void bind(SmallWorld world) {
        SmallBuffers buffers = world.buffers();
        DeviceBuffer status = world.state().status;
        DeviceBuffer bucket = buffers.kicked;
        DeviceBuffer unsorted = world.now().other;
        int cells = world.levels().cells;
        int tiles = world.tiles().parts();
        clear.arguments(buffers.bucketStart, buffers.tileStart, status, cells, tiles)
                .range(Math.max(cells, tiles) + 1L, world.group());
        bin.arguments(
                        world.before().body,
                        buffers.levels,
                        buffers.rule,
                        status,
                        world.circles(),
                        bucket,
                        buffers.bucketStart)
                .range(world.circles(), world.group());
        scan.bind(world, buffers.bucketStart, cells + 1, -1);
        scatter.arguments(bucket, buffers.bucketStart, status, world.circles(), unsorted)
                .range(world.circles(), world.group());
        order.arguments(
                        unsorted,
                        bucket,
                        buffers.bucketStart,
                        world.before().body,
                        world.before().id,
                        status,
                        world.circles(),
                        world.now().body,
                        world.now().id,
                        buffers.from,
                        world.now().listStart)
                .range(world.circles(), world.group());
    }

    void run() {
        clear.launch();
        bin.launch();
        scan.run();
        scatter.launch();
        order.launch();
    }
}
