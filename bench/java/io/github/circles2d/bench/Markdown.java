package io.github.circles2d.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/** A page with tables. */
final class Markdown {
    private final StringBuilder text = new StringBuilder();

    /** A page that starts with what it was measured on, when and with what. */
    static Markdown page(String title, Rows rows) {
        return new Markdown()
                .line("# " + title)
                .paragraph(rows.machine())
                .paragraph("Measured " + rows.dates() + " with " + rows.versions() + ".");
    }

    Markdown line(String line) {
        text.append(line).append('\n');
        return this;
    }

    /** A paragraph of its own. */
    Markdown paragraph(String paragraph) {
        return line("").line(paragraph);
    }

    /** Starts a table; the first {@code left} columns hold words, the others numbers. */
    Markdown table(int left, String... heads) {
        line("").row((Object[]) heads);
        Object[] rule = new Object[heads.length];
        for (int i = 0; i < rule.length; i++) {
            rule[i] = i < left ? "---" : "---:";
        }
        return row(rule);
    }

    Markdown row(Object... cells) {
        StringBuilder row = new StringBuilder("|");
        for (Object cell : cells) {
            row.append(' ').append(cell).append(" |");
        }
        return line(row.toString());
    }

    /** A picture beside the page. */
    Markdown picture(String words, String file) {
        return line("").line("![" + words + "](" + file + ")");
    }

    /** Prints the page and writes it. */
    void save(Path file) throws IOException {
        System.out.println("\n" + text);
        Files.createDirectories(file.toAbsolutePath().getParent());
        Files.writeString(file, text);
    }

    /** A count of circles, with separators. */
    static String count(String number) {
        return String.format(Locale.ROOT, "%,d", Long.parseLong(number));
    }

    /** A figure with three digits that count, or as it is where it is no number. */
    static String figure(String number) {
        double value;
        try {
            value = Double.parseDouble(number);
        } catch (NumberFormatException e) {
            return number;
        }
        if (value == 0 || !Double.isFinite(value)) {
            return value == 0 ? "0" : number;
        }
        int digits = 2 - (int) Math.floor(Math.log10(Math.abs(value)));
        if (digits > 6) {
            return String.format(Locale.ROOT, "%.1e", value);
        }
        return digits <= 0
                ? String.format(Locale.ROOT, "%,.0f", value)
                : String.format(Locale.ROOT, "%." + digits + "f", value);
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
