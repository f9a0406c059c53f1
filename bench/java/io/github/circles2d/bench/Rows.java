package io.github.circles2d.bench;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * The figures of a report, a file of comma-separated values that is written after each of them: a run that is cut short loses one, and
 * runs add up. The first columns say what was measured; a figure of the same replaces the older. The last is the date. Two lines
 * at the top name the machine and the versions of the last run.
 */
final class Rows {
    private final Path file;
    private final List<String> columns;
    private final int keys;
    private final Map<List<String>, Map<String, String>> rows = new LinkedHashMap<>();
    private String machine = "";
    private String versions = "";

    /**
     * Reads what is there.
     *
     * @param keys how many of the columns say what was measured
     */
    Rows(Path file, int keys, String... columns) throws IOException {
        this.file = file;
        this.keys = keys;
        this.columns = new ArrayList<>(Arrays.asList(columns));
        this.columns.add("date");
        if (Files.exists(file)) {
            List<String> lines = Files.readAllLines(file);
            if (lines.size() < 3 || !lines.get(2).equals(String.join(",", this.columns))) {
                throw new IOException(file + " has other columns than " + this.columns);
            }
            machine = lines.get(0).substring(2);
            versions = lines.get(1).substring(2);
            for (String line : lines.subList(3, lines.size())) {
                add(line.substring(1, line.length() - 1).split("\",\"", -1));
            }
        }
    }

    /** Says what the rows that are put from now on are measured with; the machine is this one. */
    void measure(String with) {
        machine = Machine.describe();
        versions = with;
    }

    String machine() {
        return machine;
    }

    String versions() {
        return versions;
    }

    private void add(String... values) {
        Map<String, String> row = new LinkedHashMap<>();
        for (int i = 0; i < columns.size(); i++) {
            row.put(columns.get(i), i < values.length ? values[i] : "");
        }
        rows.put(List.copyOf(Arrays.asList(values).subList(0, keys)), row);
    }

    /** Adds or replaces a row, prints it and writes the file; values left out at the end are empty. */
    synchronized void put(Object... values) {
        String[] all = new String[columns.size()];
        Arrays.fill(all, "");
        for (int i = 0; i < values.length; i++) {
            all[i] = brief(String.valueOf(values[i]).replaceAll("[\"\r\n]+", "'"));
        }
        System.out.println(String.join("  ", all).strip());
        all[all.length - 1] = LocalDate.now().toString();
        add(all);
        List<String> lines = new ArrayList<>(List.of("# " + machine, "# " + versions));
        lines.add(String.join(",", columns));
        rows.values().forEach(row -> lines.add("\"" + String.join("\",\"", row.values()) + "\""));
        try {
            Files.createDirectories(file.toAbsolutePath().getParent());
            Path part = file.resolveSibling(file.getFileName() + ".part");
            Files.write(part, lines);
            Files.move(part, file, StandardCopyOption.REPLACE_EXISTING);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Five digits of a fraction. */
    private static String brief(String value) {
        return value.matches("-?\\d+\\.\\d+(E-?\\d+)?")
                ? new BigDecimal(value)
                        .round(new MathContext(5))
                        .stripTrailingZeros()
                        .toPlainString()
                : value;
    }

    /** All rows that fit. */
    List<Map<String, String>> where(Predicate<Map<String, String>> fits) {
        return rows.values().stream().filter(fits).toList();
    }

    /** The row of these keys. */
    Optional<Map<String, String>> row(Object... key) {
        return Optional.ofNullable(
                rows.get(Arrays.stream(key).map(String::valueOf).toList()));
    }

    /** The different values of a column, in the order in which they came. */
    List<String> values(String column) {
        return rows.values().stream().map(row -> row.get(column)).distinct().toList();
    }

    /** The same as numbers, ascending. */
    List<Integer> numbers(String column) {
        return values(column).stream().map(Integer::valueOf).sorted().toList();
    }

    /** From when the figures are. */
    String dates() {
        List<String> dates = values("date").stream().sorted().toList();
        return dates.isEmpty()
                ? "never"
                : dates.size() == 1 ? dates.get(0) : dates.get(0) + " to " + dates.get(dates.size() - 1);
    }
}
