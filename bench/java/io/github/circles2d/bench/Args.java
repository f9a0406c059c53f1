package io.github.circles2d.bench;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The command line of a report: {@code --name value}, or {@code -p name=value} as JMH has it. Lists are separated by commas. What is
 * neither is left for JMH.
 */
final class Args {
    private static final Set<String> COMMON = Set.of("out", "limit", "device", "circles", "draw");

    private final Map<String, String> named = new LinkedHashMap<>();
    private final List<String> rest = new ArrayList<>();

    private Args() {}

    /**
     * Reads a command line.
     *
     * @param more the names that this report takes beside those that all take: out, limit, device, circles and draw
     * @throws IllegalArgumentException if another name is given, or a value is missing
     */
    static Args parse(String[] args, String... more) {
        Args parsed = new Args();
        for (int i = 0; i < args.length; i++) {
            if (args[i].equals("--draw")) {
                parsed.named.put("draw", "");
            } else if (args[i].startsWith("--") || args[i].equals("-p")) {
                if (i + 1 == args.length) {
                    throw new IllegalArgumentException(args[i] + " needs a value");
                }
                boolean jmh = args[i].equals("-p");
                String[] pair = jmh ? args[i + 1].split("=", 2) : new String[] {args[i].substring(2), args[i + 1]};
                if (pair.length < 2
                        || !COMMON.contains(pair[0]) && !Arrays.asList(more).contains(pair[0])) {
                    throw new IllegalArgumentException(
                            args[i] + " " + args[i + 1] + ": known are " + COMMON + " and " + Arrays.toString(more));
                }
                parsed.named.put(pair[0], pair[1]);
                i++;
            } else {
                parsed.rest.add(args[i]);
            }
        }
        return parsed;
    }

    /** Ends the program's way here if there is anything that only JMH would understand. */
    Args withoutJmh() {
        if (!rest.isEmpty()) {
            throw new IllegalArgumentException("unknown: " + String.join(" ", rest));
        }
        return this;
    }

    /** What is left for JMH. */
    String[] rest() {
        return rest.toArray(new String[0]);
    }

    /** A list, or what it is without a word about it. */
    List<String> list(String name, String... otherwise) {
        return named.containsKey(name) ? List.of(named.get(name).split(",")) : List.of(otherwise);
    }

    /** The same for whole numbers, which may have underscores; in ascending order. */
    List<Integer> numbers(String name, String... otherwise) {
        return list(name, otherwise).stream()
                .map(n -> Integer.valueOf(n.replace("_", "")))
                .sorted()
                .toList();
    }

    /** Seconds that one figure may take, about. */
    int limit(int otherwise) {
        return named.containsKey("limit") ? Integer.parseInt(named.get("limit")) : otherwise;
    }

    /** Only write the tables and charts again from the figures that are in the folder. */
    boolean drawOnly() {
        return named.containsKey("draw");
    }

    /** The folder of the results: {@code --out}, or {@code bench/results/} and the preferred device's name. */
    Path folder() {
        return Path.of(named.containsKey("out") ? named.get("out") : "bench/results/" + Machine.folder());
    }
}
