package io.github.circles2d;

import io.github.circles2d.demo.Scene;
import java.lang.management.ManagementFactory;
import java.lang.ref.WeakReference;
import java.net.URL;
import java.net.URLClassLoader;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.management.ObjectName;

/** What the child processes of {@link ForkedJvmTest} do; the first argument names it. */
final class ForkedJvm {
    private ForkedJvm() {}

    public static void main(String[] args) throws Exception {
        switch (args[0]) {
            case "world" -> {
                // two worlds: what is said once is not said again
                System.out.println("list=" + ComputeDevice.list());
                System.out.println("hash=" + hash() + " " + hash());
            }
            case "preferred" -> System.out.println("preferred=" + ComputeDevice.preferred());
            case "loaders" -> {
                System.out.println("hash=" + inLoader() + " " + inLoader());
            }
            case "leak" -> leak();
            case "signals" -> {
                ComputeDevice.list();
                signals("listed", 0);
                System.out.println("hash=" + hash());
                signals("stepped", 0);
            }
            case "threads" -> System.out.println("hash=" + hashOfAPile());
            default -> throw new IllegalArgumentException(args[0]);
        }
    }

    /** The hash of a small default world after ten steps. Called by reflection, too. */
    public static String hash() {
        try (Circles2D world = Circles2D.builder().build()) {
            for (int i = 0; i < 20; i++) {
                world.addCircle(0.3f + 0.02f * i, 0.5f, 0.02f, 1);
            }
            world.step(10);
            return world.device().type() + ":" + world.stateHash();
        }
    }

    /** Of a pile large enough for as many parts as there are threads. */
    private static String hashOfAPile() {
        Circles2D.Builder builder = Circles2D.builder()
                .device(ComputeDevice.host())
                .solver(Solver.SMALL_STEPS)
                .indexStrategy(IndexStrategy.grid());
        try (Circles2D world = Scene.PILE.build(builder, 20_000)) {
            world.step(20);
            return world.stateHash() + " after " + world.stats().contacts() + " contacts";
        }
    }

    private static String inLoader() throws Exception {
        URL[] path = Stream.of(System.getProperty("java.class.path").split(System.getProperty("path.separator")))
                .map(ForkedJvm::url)
                .collect(Collectors.toList())
                .toArray(URL[]::new);
        try (URLClassLoader loader = new URLClassLoader(path, ClassLoader.getPlatformClassLoader())) {
            Class<?> other = loader.loadClass(ForkedJvm.class.getName());
            if (other == ForkedJvm.class) {
                throw new AssertionError("the same class loader");
            }
            var method = other.getDeclaredMethod("hash");
            method.setAccessible(true);
            return (String) method.invoke(null);
        }
    }

    private static void signals(String when, int zero) throws Exception {
        System.out.println(when + " " + handler());
        try {
            System.out.println(when + ": a division by zero gives " + 1 / zero);
        } catch (ArithmeticException e) {
            System.out.println(when + ": a division by zero throws");
        }
    }

    /** Who handles the signal for a bad address. */
    private static String handler() throws Exception {
        Object info = ManagementFactory.getPlatformMBeanServer()
                .invoke(new ObjectName("com.sun.management:type=DiagnosticCommand"), "vmInfo", null, null);
        return info.toString()
                .lines()
                .filter(line -> line.contains("SIGSEGV: "))
                .findFirst()
                .orElseThrow();
    }

    private static URL url(String file) {
        try {
            return java.nio.file.Path.of(file).toUri().toURL();
        } catch (java.net.MalformedURLException e) {
            throw new AssertionError(e);
        }
    }

    private static void leak() throws InterruptedException {
        List<WeakReference<Circles2D>> worlds = List.of(
                new WeakReference<>(world(false, true)),
                new WeakReference<>(world(false, false)),
                new WeakReference<>(world(true, true)),
                new WeakReference<>(world(true, false)));
        for (int i = 0; i < 200 && worlds.stream().anyMatch(world -> world.get() != null); i++) {
            System.gc();
            Thread.sleep(20);
        }
        // the cleaner runs in a thread of its own
        Thread.sleep(500);
        System.out.println("collected=" + worlds.stream().allMatch(world -> world.get() == null));
        System.out.println("threads="
                + Thread.getAllStackTraces().keySet().stream()
                        .filter(thread -> thread.getName().equals("circles2d steps"))
                        .count());
    }

    private static Circles2D world(boolean background, boolean close) {
        Circles2D world = Circles2D.builder()
                .device(ComputeDevice.host())
                .background(background)
                .build();
        if (background) {
            world.step(Integer.MAX_VALUE);
        }
        if (close) {
            world.close();
        }
        return world;
    }
}
