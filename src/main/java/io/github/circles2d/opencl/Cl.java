package io.github.circles2d.opencl;

import io.github.circles2d.CapacityException;
import io.github.circles2d.OpenClException;
import org.jocl.CL;

/** Turns statuses into exceptions. */
final class Cl {
    private static final System.Logger LOG = System.getLogger("io.github.circles2d");

    private Cl() {}

    /** @throws OpenClException if the call did not succeed */
    static void check(String call, int status) {
        if (status != CL.CL_SUCCESS) {
            throw new OpenClException(call, status, CL.stringFor_errorCode(status));
        }
    }

    /** As {@link #check}, for what is done on the way out: there is more to release, so it is logged and not thrown. */
    static void checkRelease(String call, int status) {
        if (status != CL.CL_SUCCESS) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    "{0} failed: {1} ({2}); what it was to release may stay allocated",
                    call,
                    CL.stringFor_errorCode(status),
                    status);
        }
    }

    /**
     * As {@link #check}, for a call that allocates.
     *
     * @throws CapacityException if the device has no memory for it
     */
    static void checkAllocation(String call, int status, String what, long bytes) {
        if (status == CL.CL_MEM_OBJECT_ALLOCATION_FAILURE
                || status == CL.CL_OUT_OF_HOST_MEMORY
                || status == CL.CL_OUT_OF_RESOURCES
                || status == CL.CL_INVALID_BUFFER_SIZE) {
            throw new CapacityException("the device has no room for " + what + ", " + bytes + " bytes: " + call
                    + " gives " + CL.stringFor_errorCode(status));
        }
        check(call, status);
    }
}
