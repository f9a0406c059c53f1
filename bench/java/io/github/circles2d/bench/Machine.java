package io.github.circles2d.bench;

import io.github.circles2d.ComputeDevice;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Properties;
import java.util.Set;
import java.util.stream.Stream;

/** What the figures were taken on. */
final class Machine {
    private Machine() {}

    /**
     * The device of a name as {@link ComputeDevice#find} takes it, or {@code preferred}.
     *
     * @throws IllegalArgumentException if there is none
     */
    static ComputeDevice device(String name) {
        return name.equals("preferred")
                ? ComputeDevice.preferred()
                : ComputeDevice.find(name)
                        .orElseThrow(() -> new IllegalArgumentException(
                                "device = " + name + ": there are " + ComputeDevice.list()));
    }

    /** The devices that are asked for, or all: the host, then processors, then GPUs. */
    static List<ComputeDevice> devices(Args args) {
        List<String> names = args.list("device");
        Stream<ComputeDevice> devices =
                names.isEmpty() ? ComputeDevice.list().stream() : names.stream().map(Machine::device);
        // of several of one name, the first: they would have one row
        Set<String> seen = new HashSet<>();
        return devices.filter(device -> seen.add(label(device)))
                .sorted(Comparator.comparingInt(Machine::rank))
                .toList();
    }

    private static int rank(ComputeDevice device) {
        return switch (device.type()) {
            case HOST -> 0;
            case CPU -> 1;
            case ACCELERATOR -> 2;
            case GPU -> 3;
        };
    }

    /** The number of a device in the list of this machine, by which every JVM on it finds it again. */
    static String index(ComputeDevice device) {
        return String.valueOf(ComputeDevice.list().indexOf(device));
    }

    /** What tables call a device: plain Java and OpenCL on the same processor are two. */
    static String label(ComputeDevice device) {
        return switch (device.type()) {
            case HOST -> "plain Java";
            case CPU -> (device.platform().startsWith("Portable") ? "PoCL" : "OpenCL") + " on the processor";
            default -> device.name();
        };
    }

    /** A name for the folder of this machine's results: that of its preferred device, and its cores if that is no GPU. */
    static String folder() {
        ComputeDevice device = ComputeDevice.preferred();
        String name = device.name().toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-");
        return rank(device) > 1 ? name : name + "-" + Runtime.getRuntime().availableProcessors() + "core";
    }

    /** The processor, Java and the OpenCL devices, one line. */
    static String describe() {
        StringBuilder all = new StringBuilder(processor());
        all.append(", ").append(Runtime.getRuntime().availableProcessors()).append(" logical cores; ");
        all.append(System.getProperty("os.name")).append(' ').append(System.getProperty("os.arch"));
        all.append("; ").append(System.getProperty("java.vm.name"));
        all.append(' ').append(System.getProperty("java.version"));
        for (ComputeDevice device : ComputeDevice.list()) {
            if (device.type() != ComputeDevice.Type.HOST) {
                all.append("; ").append(device);
            }
        }
        return all.toString();
    }

    private static String processor() {
        try (Stream<String> lines = Files.lines(Path.of("/proc/cpuinfo"))) {
            return lines.filter(line -> line.startsWith("model name"))
                    .findFirst()
                    .map(line -> line.substring(line.indexOf(':') + 1).strip())
                    .orElse("processor unknown");
        } catch (IOException e) {
            return "processor unknown";
        }
    }

    /** The version of a library on the class path, as Maven left it in its jar. */
    static String version(String group, String artifact) {
        String file = "/META-INF/maven/" + group + "/" + artifact + "/pom.properties";
        try (InputStream in = Machine.class.getResourceAsStream(file)) {
            Properties properties = new Properties();
            if (in != null) {
                properties.load(in);
            }
            return properties.getProperty("version", "?");
        } catch (IOException e) {
            return "?";
        }
    }
}
