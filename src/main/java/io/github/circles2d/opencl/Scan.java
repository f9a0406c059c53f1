package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Tuning;

/** Host code of {@code kernels/scan.cl}: turns counts into sums. */
final class Scan {
    private final Kernel few;
    private final Kernel parts;
    private final Kernel add;
    private boolean isFew;

    Scan(Session session, Program program) {
        few = new Kernel(session, program, "c2d_scan_few");
        parts = new Kernel(session, program, "c2d_scan_parts");
        add = new Kernel(session, program, "c2d_scan_add");
    }

    /**
     * @param part the part of the heap that the values are in
     * @param lists whether they are the lengths of lists, which must not be more than there is room for
     */
    void bind(SmallWorld world, int part, int count, boolean lists) {
        Object[] known = world.known();
        int values = world.heap().at(world.turn(), part);
        int isLists = lists ? 1 : 0;
        isFew = world.few() && count <= Tuning.SCAN_FEW;
        few.range(1, world.oneGroup()).arguments(known, values, count, isLists, new Kernel.Local(4L * few.group()));
        parts.range((count + Tuning.SCAN - 1L) / Tuning.SCAN, world.group())
                .arguments(known, values, count, new Kernel.Local(4L * parts.group()));
        add.range((count + Tuning.SCAN - 1L) / Tuning.SCAN, world.group())
                .arguments(known, values, count, isLists, new Kernel.Local(4L * add.group()));
    }

    void run() {
        if (isFew) {
            few.launch();
            return;
        }
        parts.launch();
        add.launch();
    }
}
