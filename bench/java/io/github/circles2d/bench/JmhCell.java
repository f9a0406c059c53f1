package io.github.circles2d.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.ChainedOptionsBuilder;
import org.openjdk.jmh.runner.options.CommandLineOptionException;
import org.openjdk.jmh.runner.options.CommandLineOptions;
import org.openjdk.jmh.runner.options.OptionsBuilder;

/**
 * One cell of a table, by JMH: one benchmark with one value of each parameter. JMH's own words go to a file, to be looked at only
 * where it fails.
 *
 * @param result what came out, or null
 * @param failure why nothing came out, a few words, or null
 */
record JmhCell(RunResult result, String failure) {
    /**
     * Runs it.
     *
     * @param args options of JMH, which go before the benchmark's own
     * @param seconds what an iteration is expected to take, or 0
     * @param limit seconds that the cell may take, about: iterations are left out to keep it
     */
    static JmhCell run(
            Class<?> benchmark, Args args, Map<String, String> parameters, double seconds, int limit, String profiler)
            throws IOException, CommandLineOptionException {
        CommandLineOptions given = new CommandLineOptions(args.rest());
        Path log = Files.createTempFile("jmh", ".log");
        ChainedOptionsBuilder options = new OptionsBuilder()
                .parent(given)
                .include("\\b" + benchmark.getSimpleName() + "\\b")
                .output(log.toString())
                .shouldFailOnError(false);
        parameters.forEach(options::param);
        if (profiler != null) {
            options.addProfiler(profiler);
        }
        if (seconds > 0
                && seconds * 7 > limit
                && !given.getMeasurementIterations().hasValue()) {
            options.warmupIterations(seconds * 2 < limit ? 1 : 0);
            options.measurementIterations((int) Math.max(1, Math.min(5, limit / seconds - 1)));
        }
        try {
            Collection<RunResult> results = new Runner(options.build()).run();
            return results.isEmpty()
                    ? new JmhCell(null, reason(log))
                    : new JmhCell(results.iterator().next(), null);
        } catch (RunnerException e) {
            return new JmhCell(null, String.valueOf(e.getMessage()));
        } finally {
            Files.deleteIfExists(log);
        }
    }

    /** The mean of all iterations, in the unit of the benchmark. */
    double score() {
        return result.getPrimaryResult().getScore();
    }

    /** Half the width of JMH's 99.9 % confidence interval, or an empty text for one iteration. */
    String error() {
        double error = result.getPrimaryResult().getScoreError();
        return Double.isNaN(error) ? "" : String.valueOf(error);
    }

    /** Another figure of the same run, a sum or a mean as the figure has it. */
    double secondary(String name) {
        return result.getSecondaryResults().keySet().stream()
                .filter(key -> key.endsWith(name))
                .mapToDouble(key -> result.getSecondaryResults().get(key).getScore())
                .findFirst()
                .orElse(Double.NaN);
    }

    /** The first exception that a log tells of. */
    static String reason(Path log) throws IOException {
        try (Stream<String> lines = Files.lines(log)) {
            Optional<String> first = lines.map(String::strip)
                    .map(line -> line.replaceFirst("^(Caused by: |Exception in thread \"[^\"]*\" )", ""))
                    .filter(line -> line.matches("([a-z]\\w*\\.)+\\w*(Exception|Error)\\b.*"))
                    .findFirst();
            return first.map(line -> line.length() > 200 ? line.substring(0, 200) : line)
                    .orElse("the JVM ended without a word");
        }
    }
}
