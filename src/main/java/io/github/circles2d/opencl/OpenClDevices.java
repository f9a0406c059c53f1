package io.github.circles2d.opencl;

import java.util.ArrayList;
import java.util.List;
import org.jocl.CL;
import org.jocl.Pointer;
import org.jocl.cl_device_id;
import org.jocl.cl_platform_id;

/** Finds the OpenCL devices of the machine. What is missing or broken is logged and left out, never thrown. */
public final class OpenClDevices {
    private static final System.Logger LOG = System.getLogger("io.github.circles2d");
    private static final int CL_PLATFORM_NOT_FOUND_KHR = -1001;
    private static final String WITHOUT = "circles run on the host device, in plain Java";

    private OpenClDevices() {}

    /** The devices of every platform; empty where there is no OpenCL. */
    public static List<OpenClDevice> list() {
        try {
            return list(JoclApi.load());
        } catch (LinkageError | UnsupportedOperationException e) {
            // no loader; or one without the functions that JOCL then calls
            LOG.log(System.Logger.Level.INFO, "no OpenCL on this machine ({0}); {1}", e, WITHOUT);
            return List.of();
        }
    }

    static List<OpenClDevice> list(ClApi api) {
        int[] count = new int[1];
        int status = api.getPlatformIDs(0, null, count);
        if (status == CL_PLATFORM_NOT_FOUND_KHR || (status == CL.CL_SUCCESS && count[0] == 0)) {
            LOG.log(
                    System.Logger.Level.INFO,
                    "OpenCL has no platform on this machine (no driver is installed); {0}",
                    WITHOUT);
            return List.of();
        }
        cl_platform_id[] platforms = new cl_platform_id[Math.max(count[0], 0)];
        if (status == CL.CL_SUCCESS) {
            status = api.getPlatformIDs(platforms.length, platforms, null);
        }
        if (status != CL.CL_SUCCESS) {
            warn("OpenCL gives no platforms", status);
            return List.of();
        }
        List<OpenClDevice> devices = new ArrayList<>();
        for (cl_platform_id platform : platforms) {
            addDevices(api, platform, devices);
        }
        SignalCanary.handBack();
        return devices;
    }

    private static void addDevices(ClApi api, cl_platform_id platform, List<OpenClDevice> to) {
        int[] count = new int[1];
        int status = api.getDeviceIDs(platform, CL.CL_DEVICE_TYPE_ALL, 0, null, count);
        cl_device_id[] ids = new cl_device_id[Math.max(count[0], 0)];
        if (status == CL.CL_SUCCESS && ids.length > 0) {
            status = api.getDeviceIDs(platform, CL.CL_DEVICE_TYPE_ALL, ids.length, ids, null);
        }
        if (status == CL.CL_DEVICE_NOT_FOUND) {
            LOG.log(
                    System.Logger.Level.INFO,
                    "an OpenCL platform has no devices (PoCL says so when its cache folder cannot be written)");
            return;
        }
        if (status != CL.CL_SUCCESS) {
            warn("an OpenCL platform gives no devices", status);
            return;
        }
        for (cl_device_id id : ids) {
            try {
                OpenClDevice device = OpenClDevice.of(api, platform, id);
                if (device != null) {
                    to.add(device);
                }
            } catch (RuntimeException e) {
                LOG.log(System.Logger.Level.WARNING, "an OpenCL device is left out", e);
            }
        }
    }

    private static void warn(String what, int status) {
        LOG.log(
                System.Logger.Level.WARNING,
                "{0}: {1}; {2}",
                what,
                CL.stringFor_errorCode(status),
                "its devices are left out");
    }

    /** A text that a driver gives. */
    interface TextQuery {
        int ask(long size, Pointer value, long[] needed);
    }

    static String text(String call, TextQuery query) {
        long[] needed = new long[1];
        Cl.check(call, query.ask(0, null, needed));
        byte[] bytes = new byte[Math.toIntExact(needed[0])];
        if (bytes.length == 0) {
            return "";
        }
        Cl.check(call, query.ask(bytes.length, Pointer.to(bytes), null));
        return new String(bytes, 0, bytes.length - 1, java.nio.charset.StandardCharsets.UTF_8).strip();
    }
}
