package io.github.circles2d.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** One figure in a JVM of its own: a fresh heap and compiler, an end after a time, and a crash that ends nothing else. */
final class Child {
    private static final String RESULT = "result:";

    private Child() {}

    /** What a child says as its last word. */
    static void result(Object... values) {
        System.out.println(RESULT
                + String.join(";", Arrays.stream(values).map(String::valueOf).toList()));
    }

    /**
     * Runs the main method of a class.
     *
     * @param seconds after which it is ended
     * @return what it gave to {@link #result}; or one text that says why there is nothing
     */
    static List<String> run(Class<?> main, int seconds, Object... args) throws IOException {
        return run(Map.of(), main, seconds, args);
    }

    /** The same with these variables in its environment beside those of this JVM. */
    static List<String> run(Map<String, String> environment, Class<?> main, int seconds, Object... args)
            throws IOException {
        Path log = Files.createTempFile("child", ".log");
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), main.getName()));
        Arrays.stream(args).map(String::valueOf).forEach(command::add);
        ProcessBuilder builder =
                new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(log.toFile());
        builder.environment().putAll(environment);
        Process process = builder.start();
        Thread ender = new Thread(process::destroyForcibly);
        Runtime.getRuntime().addShutdownHook(ender);
        try {
            boolean ended = process.waitFor(seconds, TimeUnit.SECONDS);
            try (Stream<String> lines = Files.lines(log)) {
                return lines.filter(line -> line.startsWith(RESULT))
                        .findFirst()
                        .map(line -> List.of(line.substring(RESULT.length()).split(";", -1)))
                        .orElse(List.of(ended ? reason(process, log) : "not done in " + seconds + " s"));
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return List.of("interrupted");
        } finally {
            process.destroyForcibly();
            Runtime.getRuntime().removeShutdownHook(ender);
            Files.deleteIfExists(log);
        }
    }

    private static String reason(Process process, Path log) throws IOException {
        return JmhCell.reason(log) + " (status " + process.exitValue() + ")";
    }
}
