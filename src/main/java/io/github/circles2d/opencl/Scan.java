package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Tuning;

/** Host code of {@code kernels/scan.cl}: turns counts into sums. */
final class Scan {
    private final Kernel parts;
    private final Kernel sums;
    private final Kernel add;

    Scan(Session session, Program program) {
        parts = new Kernel(session, program, "c2d_scan_parts");
        sums = new Kernel(session, program, "c2d_scan_sums");
        add = new Kernel(session, program, "c2d_scan_add");
    }

    void bind(DeviceBuffer values, int count, State state, SmallBuffers buffers, int group, int oneGroup) {
        parts.range((count + Tuning.SCAN - 1L) / Tuning.SCAN, group)
                .arguments(values, count, buffers.partSums, state.status, new Kernel.Local(4L * parts.group()));
        sums.range(1, oneGroup)
                .arguments(
                        buffers.partSums,
                        (int) parts.groups(),
                        state.status,
                        buffers.capacity(),
                        new Kernel.Local(4L * sums.group()));
        add.range(count, group).arguments(values, count, buffers.partSums, state.status, Tuning.SCAN * parts.group());
    }

    void run() {
        parts.launch();
        sums.launch();
        add.launch();
    }
}
