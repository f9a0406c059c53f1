package io.github.circles2d.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** The figures of {@link ThesisFigure3} as the thesis prints them, and a chart. */
final class Figure3Page {
    private static final Map<String, String> WORDS = Map.of(
            "formula",
            "formula (0)",
            "pair_table",
            "pair table (1)",
            "row_search",
            "row search (2)",
            "folded",
            "folded");

    private final Rows rows;
    private final List<String> devices;
    private final List<String> strategies;
    private final Markdown page;

    private Figure3Page(Rows rows) {
        this.rows = rows;
        // slowest first, as the thesis has its processor before its GPU
        devices = rows.values("device").stream()
                .sorted(Comparator.comparingDouble(device -> -millis(rows, device)))
                .toList();
        strategies = rows.values("strategy");
        page = Markdown.page("The thesis' Figure 3 today", rows);
    }

    /** Mean of a device's figures at the smallest number of circles. */
    private static double millis(Rows rows, String device) {
        String least = String.valueOf(rows.numbers("circles").get(0));
        return rows
                .where(row ->
                        row.get("device").equals(device) && row.get("circles").equals(least))
                .stream()
                .map(row -> row.get("ms"))
                .filter(ms -> ms.matches("[0-9.eE+-]+"))
                .mapToDouble(Double::parseDouble)
                .average()
                .orElse(0);
    }

    static void write(Rows rows, Path folder) throws IOException {
        new Figure3Page(rows).write(folder);
    }

    private void write(Path folder) throws IOException {
        page.paragraph(
                "Milliseconds a step of the thesis' scene, read-back included, means of 100 steps, for the strategies ("
                        + strategies.stream().map(s -> WORDS.getOrDefault(s, s)).collect(Collectors.joining(", "))
                        + ").");
        List<String> notes = new ArrayList<>();
        for (String from : rows.values("from")) {
            for (String store : rows.values("store")) {
                String file = "thesis-figure3"
                        + (store.equals("COMPACT") ? "" : "-" + store.toLowerCase(Locale.ROOT))
                        + (from.equals("0") ? "" : "-" + from) + ".png";
                String title = store + (from.equals("0") ? ", from the start" : ", after " + from + " steps");
                if (rows.where(row ->
                                row.get("from").equals(from) && row.get("store").equals(store))
                        .isEmpty()) {
                    continue;
                }
                table(title, store, from, notes);
                chart(title, store, from).save(folder.resolve(file));
                page.picture(title, file);
            }
        }
        notes.forEach(page::paragraph);
        thesis();
        page.save(folder.resolve("thesis-figure3.md"));
    }

    private void table(String title, String store, String from, List<String> notes) {
        page.paragraph("## " + title);
        List<String> heads = new ArrayList<>(List.of("circles"));
        devices.forEach(device -> heads.add(device));
        int slow = 0;
        int fast = devices.size() - 1;
        if (fast > slow) {
            heads.add("speed-up, " + devices.get(slow) + " / " + devices.get(fast));
        }
        page.table(0, heads.toArray(new String[0]));
        for (int circles : rows.numbers("circles")) {
            List<String> cells = new ArrayList<>(List.of(Markdown.count(String.valueOf(circles))));
            for (String device : devices) {
                cells.add(cell(strategies.stream()
                        .map(s -> noted(device, store, from, s, circles, notes))
                        .toList()));
            }
            if (fast > slow) {
                cells.add(cell(strategies.stream()
                        .map(s -> ratio(
                                value(devices.get(slow), store, from, s, circles),
                                value(devices.get(fast), store, from, s, circles)))
                        .toList()));
            }
            page.row(cells.toArray());
        }
    }

    private static String cell(List<String> values) {
        return "(" + String.join(", ", values) + ")";
    }

    private String value(String device, String store, String from, String strategy, int circles) {
        return rows.row(device, store, from, strategy, circles)
                .map(row -> row.get("ms"))
                .orElse("–");
    }

    private String noted(String device, String store, String from, String strategy, int circles, List<String> notes) {
        String value = value(device, store, from, strategy, circles);
        String figure = Markdown.figure(value);
        if (!figure.equals(value) || value.equals("–") || value.matches("[\\d.]+")) {
            return figure;
        }
        if (notes.stream().noneMatch(note -> note.endsWith(value))) {
            notes.add("[" + (notes.size() + 1) + "] " + value);
        }
        int note = 0;
        while (!notes.get(note).endsWith(value)) {
            note++;
        }
        return "N/A [" + (note + 1) + "]";
    }

    private static String ratio(String slow, String fast) {
        try {
            return Markdown.figure(String.valueOf(Double.parseDouble(slow) / Double.parseDouble(fast)));
        } catch (NumberFormatException e) {
            return "–";
        }
    }

    private Chart chart(String title, String store, String from) {
        Chart chart = new Chart("Figure 3 of the thesis today: " + title, "ms a step, read-back included");
        List<Integer> circles = rows.numbers("circles");
        for (String device : devices) {
            for (String strategy : strategies) {
                chart.line(
                        device + ", " + strategy,
                        devices.indexOf(device),
                        strategies.indexOf(strategy),
                        circles,
                        circles.stream()
                                .map(n -> value(device, store, from, strategy, n))
                                .toList());
            }
        }
        List<Integer> then = List.of(1250, 2500, 5000, 10000, 15000);
        return chart.line("thesis, FX-8350, pair table", 6, 1, then, List.of("2", "15", "58", "216", "451"))
                .line("thesis, R9 270X, formula", 7, 0, then, List.of("", "", "2", "6", "16"));
    }

    private void thesis() {
        page.paragraph("## The thesis, 2014")
                .paragraph(
                        "Strategies (0, 1, 2), its compiler's floats and its races; the circles keep their radii there.")
                .table(0, "circles", "AMD FX-8350, 8 cores", "AMD R9 270X", "speed-up")
                .row("1,250", "(11, 2, 9)", "(<1, <1, <1)", "(>11, >2, >9)")
                .row("2,500", "(37, 15, 34)", "(<1, 1, 1)", "(>37, 15, 34)")
                .row("5,000", "(128, 58, 121)", "(2, 2, 2)", "(64, 28, 60.5)")
                .row("10,000", "(504, 216, 473)", "(6, 9, 15)", "(84, 24, 31.5)")
                .row("15,000", "(N/A, 451, 1,100)", "(16, 26, 36)", "(N/A, 17, 30.6)");
    }
}
