package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.jocl.CL;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What depends on the process: its environment, its libraries, its signals. Each test starts JVMs of its own. */
@EnabledOnOs(OS.LINUX)
class ForkedJvmTest {
    private static final int SECONDS = 120;
    private static final Path JSIG = Path.of(System.getProperty("java.home"), "lib", "libjsig.so");

    @TempDir
    Path folder;

    /** A child process and what it said. */
    private record Child(Process process, Path output) {
        /** Waits for it to succeed; returns what it printed. */
        String succeed() throws IOException, InterruptedException {
            String said = finish();
            assertEquals(0, process.exitValue(), said);
            return said;
        }

        String finish() throws IOException, InterruptedException {
            boolean ended = process.waitFor(SECONDS, TimeUnit.SECONDS);
            process.destroyForcibly().waitFor();
            String said = Files.readString(output);
            assertTrue(ended, () -> "no end after " + SECONDS + " s: " + said);
            return said;
        }
    }

    private Child start(Map<String, String> environment, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:ErrorFile=" + folder.resolve("hs_err_%p.log"),
                "-cp",
                place(Circles2D.class) + ":" + place(ForkedJvm.class) + ":" + place(CL.class)));
        command.addAll(List.of(arguments));
        Path output = Files.createTempFile(folder, "child", ".out");
        ProcessBuilder builder =
                new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(output.toFile());
        builder.environment().remove(ComputeDevice.VARIABLE);
        builder.environment().put("LD_PRELOAD", JSIG.toString());
        builder.environment().putAll(environment);
        builder.environment().values().removeIf(String::isEmpty);
        return new Child(builder.start(), output);
    }

    private static String place(Class<?> type) {
        try {
            return Path.of(type.getProtectionDomain()
                            .getCodeSource()
                            .getLocation()
                            .toURI())
                    .toString();
        } catch (java.net.URISyntaxException e) {
            throw new AssertionError(e);
        }
    }

    private static final String MAIN = ForkedJvm.class.getName();

    private static int times(String said, String what) {
        return said.split(java.util.regex.Pattern.quote(what), -1).length - 1;
    }

    private static void hostAlone(String said, String reason) {
        assertTrue(said.contains("list=[" + ComputeDevice.host() + "]"), said);
        assertEquals(2, times(said, "HOST:"), said);
        assertEquals(1, times(said, reason), said);
        assertEquals(1, times(said, "plain Java\n"), said);
    }

    /** A loader that is no library, and a library that is no loader. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void withoutAUsableLoaderWorldsRunOnTheHost(boolean library) throws Exception {
        for (String name : List.of("libOpenCL.so.1", "libOpenCL.so")) {
            if (library) {
                Files.copy(JSIG, folder.resolve(name));
            } else {
                Files.writeString(folder.resolve(name), "not a library\n");
            }
        }
        String said = start(Map.of("LD_LIBRARY_PATH", folder.toString()), MAIN, "world")
                .succeed();
        hostAlone(said, "no OpenCL on this machine");
        assertTrue(said.contains(library ? "UnsupportedOperationException" : "UnsatisfiedLinkError"), said);
    }

    @Test
    void withoutAPlatformWorldsRunOnTheHost() throws Exception {
        Path empty = Files.createDirectory(folder.resolve("vendors"));
        String said = start(Map.of("OCL_ICD_VENDORS", empty.toString()), MAIN, "world")
                .succeed();
        hostAlone(said, "OpenCL has no platform on this machine");
    }

    /** Permissions do not stop root; that a parent is a file does. */
    @Test
    void anUnwritablePoclCacheNamesTheCacheAndEndsOnTheHost() throws Exception {
        requirePocl();
        Path file = Files.createFile(folder.resolve("file"));
        String said = start(Map.of("POCL_CACHE_DIR", file.resolve("cache").toString()), MAIN, "world")
                .succeed();
        assertTrue(said.contains("cache folder cannot be written"), said);
        assertEquals(2, times(said, "HOST:"), said);
    }

    @Test
    void aDeviceThatIsNotThereIsNamedWithThoseThatAre() throws Exception {
        Child child = start(Map.of(), "-Dcircles2d.device=nonsense", MAIN, "world");
        String said = child.finish();
        assertEquals(1, child.process().exitValue(), said);
        assertTrue(said.contains("NoDeviceException: no device \"nonsense\""), said);
        assertTrue(
                said.contains("there are: ")
                        && said.contains(ComputeDevice.host().toString()),
                said);
        for (ComputeDevice device : ComputeDevice.list()) {
            assertTrue(said.contains(device.name()), said);
        }
    }

    @ParameterizedTest
    @CsvSource({"host,'',-1", "HOST,'',-1", "0,'',0", "'',host,-1", "'',0,0", "host,0,-1"})
    void propertyAndVariableChooseTheDeviceAndThePropertyGoesFirst(String property, String variable, int index)
            throws Exception {
        List<ComputeDevice> all = ComputeDevice.list();
        ComputeDevice wanted = index < 0 ? ComputeDevice.host() : all.get(index);
        List<String> arguments = new ArrayList<>(List.of(MAIN, "preferred"));
        if (!property.isEmpty()) {
            arguments.add(0, "-Dcircles2d.device=" + property);
        }
        String said = start(Map.of(ComputeDevice.VARIABLE, variable), arguments.toArray(String[]::new))
                .succeed();
        assertTrue(said.contains("preferred=" + wanted), said);
    }

    @Test
    void twoClassLoadersOfOneJvmHaveTheLibraryEach() throws Exception {
        ComputeDevice device = TestDevices.openCl();
        String said = start(Map.of(), MAIN, "loaders").succeed();
        assertEquals(2, times(said, ComputeDevice.preferred().type() + ":"), said);
        assertTrue(ComputeDevice.list().contains(device));
    }

    @Test
    void twelveJvmsThatStartTogetherAllWork() throws Exception {
        TestDevices.openCl();
        Path temporary = Files.createDirectory(folder.resolve("tmp"));
        Path cache = Files.createDirectory(folder.resolve("cache"));
        List<Child> children = new ArrayList<>();
        for (int i = 0; i < 12; i++) {
            children.add(
                    start(Map.of("POCL_CACHE_DIR", cache.toString()), "-Djava.io.tmpdir=" + temporary, MAIN, "world"));
        }
        List<String> hashes = new ArrayList<>();
        for (Child child : children) {
            hashes.add(child.succeed()
                    .lines()
                    .filter(line -> line.startsWith("hash="))
                    .findFirst()
                    .orElse("none"));
        }
        assertTrue(hashes.get(0).startsWith("hash=" + ComputeDevice.preferred().type()), hashes.toString());
        assertEquals(1, hashes.stream().distinct().count(), hashes.toString());
    }

    @Test
    void theHostHasTheSameBitsWithAnyNumberOfThreads() throws Exception {
        String pool = "-Djava.util.concurrent.ForkJoinPool.common.parallelism=";
        String one = result(start(Map.of(), pool + 1, MAIN, "threads").succeed());
        assertTrue(one.startsWith("hash="), one);
        for (int threads : new int[] {2, 7}) {
            assertEquals(
                    one, result(start(Map.of(), pool + threads, MAIN, "threads").succeed()));
        }
    }

    @Test
    void aWorldThatWasNeverClosedIsReportedAndAClosedOneIsNot() throws Exception {
        String said = start(Map.of(), MAIN, "leak").succeed();
        assertTrue(said.contains("collected=true"), said);
        assertEquals(2, times(said, "was never closed"), said);
        assertTrue(said.contains("threads=0"), said);
    }

    /** PoCL takes over the signal of a division by zero, and its LLVM that of a bad address. Without libjsig both come back. */
    @Test
    void theJvmHasItsSignalsBack() throws Exception {
        requirePocl();
        // interpreted, as all code is at first: compiled code checks for zero by itself
        String said = start(Map.of("LD_PRELOAD", "", "CIRCLES2D_DEVICE", "cpu"), "-Xint", MAIN, "signals")
                .succeed();
        for (String when : List.of("listed", "stepped")) {
            assertTrue(said.lines().anyMatch(line -> line.startsWith(when) && line.contains("libjvm")), said);
            assertTrue(said.contains(when + ": a division by zero throws"), said);
        }
        assertEquals(0, times(said, "signal handlers"), said);
    }

    private static String result(String said) {
        return said.lines().filter(line -> line.startsWith("hash=")).findFirst().orElse("none");
    }

    /** The PoCL whose faults are known: before 4.0. */
    private static void requirePocl() {
        String platform = TestDevices.openCl().platform();
        org.junit.jupiter.api.Assumptions.assumeTrue(platform.matches(".*PoCL [0-3]\\..*"), platform);
    }
}
