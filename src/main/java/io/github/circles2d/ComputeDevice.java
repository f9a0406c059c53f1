package io.github.circles2d;

import io.github.circles2d.host.HostDevice;
import io.github.circles2d.opencl.OpenClDevices;
import io.github.circles2d.pipeline.Device;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Something that runs a world: a GPU, a CPU or an accelerator through OpenCL, or plain Java.
 *
 * <p>Where OpenCL is missing or broken there is no exception: the list then holds the host device alone, and the reason
 * is logged once at level {@code INFO} (no OpenCL) or {@code WARNING} (a driver that fails). Immutable, thread-safe.
 */
public final class ComputeDevice {
    /** The system property that names the preferred device; it goes before the environment variable. */
    public static final String PROPERTY = "circles2d.device";

    /** The environment variable that names the preferred device. */
    public static final String VARIABLE = "CIRCLES2D_DEVICE";

    /** What kind of device it is. */
    public enum Type {
        GPU,
        CPU,
        ACCELERATOR,
        /** Plain Java, without OpenCL. */
        HOST
    }

    private static final ComputeDevice HOST = new ComputeDevice(new HostDevice());

    /** The drivers are asked on first use, once in a process. */
    private static final class OpenCl {
        static final List<ComputeDevice> DEVICES = OpenClDevices.list().stream()
                .<ComputeDevice>map(ComputeDevice::new)
                .toList();
    }

    private final Device device;

    ComputeDevice(Device device) {
        this.device = device;
    }

    /** Every OpenCL device of the machine in the order of its drivers, then the host device. Never throws. */
    public static List<ComputeDevice> list() {
        List<ComputeDevice> all = new ArrayList<>(OpenCl.DEVICES);
        all.add(HOST);
        return List.copyOf(all);
    }

    /**
     * Plain Java; always there. Steps use the threads of {@link java.util.concurrent.ForkJoinPool#commonPool} besides the one that calls,
     * which does the work alone where the pool is busy.
     */
    public static ComputeDevice host() {
        return HOST;
    }

    /**
     * The device named by the system property {@value #PROPERTY} or the environment variable {@value #VARIABLE} (a name
     * or an index, as for {@link #find}); otherwise the first GPU, else the first other OpenCL device, else the host.
     *
     * @throws NoDeviceException if a device is named that is not there
     */
    public static ComputeDevice preferred() {
        String wanted = System.getProperty(PROPERTY, System.getenv(VARIABLE));
        if (wanted != null && !wanted.isBlank()) {
            return find(wanted)
                    .orElseThrow(() -> new NoDeviceException("no device \"" + wanted + "\" (from " + PROPERTY + " or "
                            + VARIABLE + "); there are: " + describe(list())));
        }
        return preferred(list());
    }

    static ComputeDevice preferred(List<ComputeDevice> all) {
        for (Type type : List.of(Type.GPU, Type.ACCELERATOR, Type.CPU)) {
            for (ComputeDevice device : all) {
                if (device.type() == type) {
                    return device;
                }
            }
        }
        return HOST;
    }

    /**
     * A device of {@link #list()} by its index there, by its type ({@code gpu}, {@code cpu}, {@code host}), or by a part
     * of its name or platform; upper and lower case are the same. The first that fits.
     */
    public static Optional<ComputeDevice> find(String nameOrIndex) {
        String wanted = Check.given("nameOrIndex", nameOrIndex).strip().toLowerCase(Locale.ROOT);
        List<ComputeDevice> all = list();
        if (wanted.matches("\\d{1,9}")) {
            int index = Integer.parseInt(wanted);
            return index < all.size() ? Optional.of(all.get(index)) : Optional.empty();
        }
        if (wanted.isEmpty()) {
            return Optional.empty();
        }
        return all.stream()
                .filter(d -> d.type().name().toLowerCase(Locale.ROOT).equals(wanted))
                .findFirst()
                .or(() -> all.stream()
                        .filter(d -> d.toString().toLowerCase(Locale.ROOT).contains(wanted))
                        .findFirst());
    }

    /** The name its driver gives. */
    public String name() {
        return device.name();
    }

    /** The platform and version its driver gives, such as {@code Portable Computing Language, OpenCL 3.0 PoCL 3.1}. */
    public String platform() {
        return device.platform();
    }

    /** What kind of device it is. */
    public Type type() {
        return device.type();
    }

    /**
     * Whether this device gives the same bits as plain Java. The first call on an OpenCL device runs a short check of its
     * arithmetic, some milliseconds and the compilation of one kernel; a device that cannot run it is not deterministic.
     */
    public boolean deterministic() {
        return device.deterministic();
    }

    Device device() {
        return device;
    }

    private static String describe(List<ComputeDevice> all) {
        return all.stream().map(ComputeDevice::toString).collect(Collectors.joining("; "));
    }

    /** Name, type and platform in one line. */
    @Override
    public String toString() {
        return name() + " [" + type() + ", " + platform() + "]";
    }
}
