package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Tuning;

/** Host code of {@code kernels/scan.cl}: turns counts into sums. */
final class Scan {
    private final Kernel few;
    private final Kernel parts;
    private final Kernel sums;
    private final Kernel add;
    private boolean isFew;

    Scan(Session session, Program program) {
        few = new Kernel(session, program, "c2d_scan_few");
        parts = new Kernel(session, program, "c2d_scan_parts");
        sums = new Kernel(session, program, "c2d_scan_sums");
        add = new Kernel(session, program, "c2d_scan_add");
    }

    /** @param capacity of contacts, where the values are the lengths of their lists; else -1 */
    void bind(SmallWorld world, DeviceBuffer values, int count, int capacity) {
        DeviceBuffer status = world.state().status;
        DeviceBuffer partSums = world.buffers().partSums;
        isFew = world.few() && count <= Tuning.SCAN_FEW;
        few.range(1, world.oneGroup()).arguments(values, count, status, capacity, new Kernel.Local(4L * few.group()));
        parts.range((count + Tuning.SCAN - 1L) / Tuning.SCAN, world.group())
                .arguments(values, count, partSums, status, new Kernel.Local(4L * parts.group()));
        sums.range(1, world.oneGroup())
                .arguments(partSums, (int) parts.groups(), status, capacity, new Kernel.Local(4L * sums.group()));
        add.range(count, world.group()).arguments(values, count, partSums, status, Tuning.SCAN * parts.group());
    }

    void run() {
        if (isFew) {
            few.launch();
            return;
        }
        parts.launch();
        sums.launch();
        add.launch();
    }
}
