package io.github.circles2d;

import io.github.circles2d.pipeline.Device;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Named;

/** The devices that tests run on. */
public final class TestDevices {
    /** The environment variable that makes a machine without OpenCL fail its tests instead of leaving some out. */
    public static final String REQUIRE = "CIRCLES2D_REQUIRE_OPENCL";

    private TestDevices() {}

    /** The first OpenCL device; without one the test that asks is left out, or fails where {@link #REQUIRE} is true. */
    public static ComputeDevice openCl() {
        ComputeDevice first = ComputeDevice.list().get(0);
        if (first.type() == ComputeDevice.Type.HOST) {
            String message = "NO OPENCL DEVICE: this test did not run. Install a driver and the loader, such as the"
                    + " packages pocl-opencl-icd and ocl-icd-libopencl1 of Debian and Ubuntu.";
            if (Boolean.parseBoolean(System.getenv(REQUIRE))) {
                Assertions.fail(message + " (" + REQUIRE + " is true)");
            }
            System.err.println(message);
            Assumptions.abort(message);
        }
        return first;
    }

    /** What {@link #openCl()} stands for inside the library. */
    public static Device openClInside() {
        return openCl().device();
    }

    /** Plain Java and OpenCL, for parameterized tests; the device is looked for when the test asks. */
    public static Stream<Named<Supplier<ComputeDevice>>> both() {
        return Stream.of(Named.of("host", ComputeDevice::host), Named.of("OpenCL", TestDevices::openCl));
    }
}
