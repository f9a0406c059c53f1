package io.github.circles2d.bench;

import io.github.circles2d.opencl.StageTimes;
import java.util.Arrays;

/**
 * The main class of {@code target/benchmarks.jar}: where the first argument is the name of a report, that report with the rest of the
 * arguments; otherwise JMH with all of them.
 *
 * <pre>{@code
 * mvn -q -Pbench verify -Dbench.args="Scaling --circles 1000,10000"
 * mvn -q -Pbench verify -Dbench.args="ThesisStep -p circles=1250"
 * }</pre>
 */
public final class Main {
    private Main() {}

    /** As {@link Main} says. */
    public static void main(String[] args) throws Exception {
        if (args.length == 0) {
            org.openjdk.jmh.Main.main(args);
            return;
        }
        String[] rest = Arrays.copyOfRange(args, 1, args.length);
        try {
            run(args, rest);
        } catch (IllegalArgumentException e) {
            System.err.println(args[0] + ": " + e.getMessage());
            System.exit(2);
        }
    }

    private static void run(String[] args, String[] rest) throws Exception {
        switch (args[0]) {
            case "ThesisFigure3" -> ThesisFigure3.main(rest);
            case "Peers" -> Peers.main(rest);
            case "Scaling" -> Scaling.main(rest);
            case "Start" -> Start.main(rest);
            case "Frame" -> Frame.main(rest);
            case "Auto" -> Auto.main(rest);
            case "Hashes" -> Hashes.main(rest);
            case "Quality" -> Quality.main(rest);
            case "StageTimes" -> StageTimes.main(rest);
            default -> org.openjdk.jmh.Main.main(args);
        }
    }
}
