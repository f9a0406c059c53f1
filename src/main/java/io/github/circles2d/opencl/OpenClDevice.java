package io.github.circles2d.opencl;

import io.github.circles2d.Circles2DException;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.pipeline.Device;
import io.github.circles2d.pipeline.SmallStages;
import io.github.circles2d.pipeline.Stages;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;
import org.jocl.CL;
import org.jocl.Pointer;
import org.jocl.Sizeof;
import org.jocl.cl_device_id;
import org.jocl.cl_platform_id;

/** One device of an OpenCL driver, with what the library needs to know of it. Immutable but for its self-check. */
public final class OpenClDevice implements Device {
    private static final System.Logger LOG = System.getLogger("io.github.circles2d");

    final ClApi api;
    final cl_platform_id platformId;
    final cl_device_id id;
    final long maxBuffer;
    final long memory;
    final int maxWorkGroup;
    /** Bytes of local memory that a work-group may have. */
    final long localMemory;
    /** Parts of a buffer begin at multiples of this, bytes. */
    final int partAlignment;

    /**
     * Memory may be mapped. JOCL waits for the end of a mapping on a thread of its own; Oclgrind's queues are for one thread, and crash.
     */
    final boolean maps;

    /** Divisions and roots are rounded correctly if the program asks for it. */
    final boolean correctlyRounded;

    /** The compiler can be told how many registers a work-item may have. */
    final boolean limitsRegisters;

    private final String name;
    private final String platform;
    private final ComputeDevice.Type type;
    private Boolean deterministic;

    private OpenClDevice(ClApi api, cl_platform_id platformId, cl_device_id id) {
        this.api = api;
        this.platformId = platformId;
        this.id = id;
        name = OpenClDevices.text("clGetDeviceInfo", (n, p, m) -> api.getDeviceInfo(id, CL.CL_DEVICE_NAME, n, p, m));
        // PoCL's version goes on, after two spaces, with how it was built
        platform = platformText(CL.CL_PLATFORM_NAME) + ", "
                + platformText(CL.CL_PLATFORM_VERSION).split("  ")[0];
        long kind = number(CL.CL_DEVICE_TYPE);
        type = (kind & CL.CL_DEVICE_TYPE_GPU) != 0
                ? ComputeDevice.Type.GPU
                : (kind & CL.CL_DEVICE_TYPE_CPU) != 0 ? ComputeDevice.Type.CPU : ComputeDevice.Type.ACCELERATOR;
        maxBuffer = number(CL.CL_DEVICE_MAX_MEM_ALLOC_SIZE);
        memory = number(CL.CL_DEVICE_GLOBAL_MEM_SIZE);
        maxWorkGroup = (int) Math.min(Integer.MAX_VALUE, number(CL.CL_DEVICE_MAX_WORK_GROUP_SIZE));
        localMemory = number(CL.CL_DEVICE_LOCAL_MEM_SIZE);
        partAlignment = (int) Math.max(16, (number(CL.CL_DEVICE_MEM_BASE_ADDR_ALIGN) & 0xFFFFFFFFL) / 8);
        maps = !platform.contains("Oclgrind");
        limitsRegisters = OpenClDevices.text(
                        "clGetDeviceInfo", (n, p, m) -> api.getDeviceInfo(id, CL.CL_DEVICE_EXTENSIONS, n, p, m))
                .contains("cl_nv_compiler_options");
        correctlyRounded = (number(CL.CL_DEVICE_SINGLE_FP_CONFIG) & CL.CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) != 0;
    }

    /** The device, or null where it cannot compile kernels or is not available. */
    static OpenClDevice of(ClApi api, cl_platform_id platform, cl_device_id id) {
        OpenClDevice device = new OpenClDevice(api, platform, id);
        return device.flag(CL.CL_DEVICE_AVAILABLE) && device.flag(CL.CL_DEVICE_COMPILER_AVAILABLE) ? device : null;
    }

    private String platformText(int what) {
        return OpenClDevices.text("clGetPlatformInfo", (n, p, m) -> api.getPlatformInfo(platformId, what, n, p, m));
    }

    /** A number of 64 bits or of the size of a pointer; every such number here is 8 bytes on a 64-bit machine. */
    private long number(int what) {
        long[] value = new long[1];
        Cl.check("clGetDeviceInfo", api.getDeviceInfo(id, what, Sizeof.cl_ulong, Pointer.to(value), null));
        return value[0];
    }

    private boolean flag(int what) {
        int[] value = new int[1];
        Cl.check("clGetDeviceInfo", api.getDeviceInfo(id, what, Sizeof.cl_uint, Pointer.to(value), null));
        return value[0] != 0;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public String platform() {
        return platform;
    }

    @Override
    public ComputeDevice.Type type() {
        return type;
    }

    @Override
    public synchronized boolean deterministic() {
        if (deterministic == null) {
            try {
                deterministic = Arithmetic.check(this);
            } catch (Circles2DException e) {
                LOG.log(System.Logger.Level.WARNING, name + " failed its self-check", e);
                deterministic = false;
            }
        }
        return deterministic;
    }

    @Override
    public Stages open(WorldConfig config) {
        return new OpenClStages(this, config);
    }

    @Override
    public SmallStages openSmall(WorldConfig config) {
        return new OpenClSmallStages(this, config);
    }

    /** Work-items of a group: those a world asks for, or what suits the device. */
    int group(WorldConfig config) {
        return group(config, Tuning.GPU_WORK_GROUP, Tuning.CPU_WORK_GROUP);
    }

    /** The same for a group that does a tile. */
    int tileGroup(WorldConfig config) {
        return group(config, Tuning.GPU_TILE_GROUP, Tuning.CPU_TILE_GROUP);
    }

    /** The same for a group that does a tile of the first tiling. */
    int firstTileGroup(WorldConfig config) {
        return group(config, Tuning.GPU_FIRST_TILE_GROUP, Tuning.CPU_TILE_GROUP);
    }

    /** The same for a group that colours one. */
    int colourGroup(WorldConfig config) {
        return group(config, Tuning.GPU_COLOUR_GROUP, Tuning.CPU_TILE_GROUP);
    }

    /** The same for a launch of one group. */
    int oneGroup(WorldConfig config) {
        return group(config, Tuning.GPU_ONE_GROUP, Tuning.CPU_ONE_GROUP);
    }

    private int group(WorldConfig config, int onGpu, int onCpu) {
        int suits = isGpu() ? onGpu : onCpu;
        return Math.min(maxWorkGroup, config.workGroup() > 0 ? config.workGroup() : suits);
    }

    /** Whether a world is done as on a GPU: there, and where a size of groups is asked for, so that it can be run without one. */
    boolean asOnGpu(WorldConfig config) {
        return isGpu() || config.workGroup() > 0;
    }

    boolean isGpu() {
        return type == ComputeDevice.Type.GPU;
    }
}
