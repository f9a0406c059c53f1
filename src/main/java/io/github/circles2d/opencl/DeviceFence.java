package io.github.circles2d.opencl;

/** How a work-group of a device makes sure that others see what it has written, while all of them run. {@code C2D_PERSISTENT}. */
enum DeviceFence {
    /** It cannot: work-groups of one launch must not wait for each other. */
    NONE,
    /** With the atomics of OpenCL 3.0, which this device has at the scope of the device. */
    OPENCL,
    /** With an instruction of NVIDIA's PTX, whose OpenCL compiler takes it; of those atomics it has none. */
    PTX;

    /** What kernels know it by, for a launch of groups that wait for each other. */
    int define() {
        return ordinal() + 1;
    }
}
