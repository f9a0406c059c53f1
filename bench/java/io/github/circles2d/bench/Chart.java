package io.github.circles2d.bench;

import java.awt.AWTError;
import java.awt.BasicStroke;
import java.awt.Color;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.lines.SeriesLines;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** Lines over the number of circles, both axes logarithmic. */
final class Chart {
    // of one brightness, and apart for those who do not see red and green
    private static final Color[] COLOURS = {
        new Color(0x0072B2), new Color(0xD55E00), new Color(0x009E73), new Color(0xCC79A7), new Color(0x56B4E9),
        new Color(0xE69F00), new Color(0x555555), new Color(0x882255), new Color(0x44AA99), new Color(0x999933)
    };
    private static final BasicStroke[] STROKES = {
        SeriesLines.SOLID, SeriesLines.DASH_DASH, SeriesLines.DOT_DOT, SeriesLines.DASH_DOT
    };

    private static final Marker[] MARKERS = {
        SeriesMarkers.CIRCLE, SeriesMarkers.SQUARE, SeriesMarkers.TRIANGLE_UP, SeriesMarkers.DIAMOND
    };

    private final XYChart chart;
    private final Range across = new Range();
    private final Range up = new Range();

    /** The powers of ten around what it took: an axis without one has no number. */
    private static final class Range {
        private double least = Double.MAX_VALUE;
        private double most;

        void take(double value) {
            least = Math.min(least, value);
            most = Math.max(most, value);
        }

        Double below() {
            return Math.pow(10, Math.floor(Math.log10(least)));
        }

        Double above() {
            return Math.pow(10, Math.max(Math.floor(Math.log10(least)) + 1, Math.ceil(Math.log10(most))));
        }
    }

    Chart(String title, String y) {
        System.setProperty("java.awt.headless", "true");
        chart = new XYChartBuilder()
                .width(1000)
                .height(600)
                .title(title)
                .xAxisTitle("circles")
                .yAxisTitle(y)
                .build();
        chart.getStyler().setXAxisLogarithmic(true).setYAxisLogarithmic(true);
        chart.getStyler()
                .setXAxisDecimalPattern("#,###")
                .setYAxisDecimalPattern("#,##0.######")
                .setPlotGridLinesColor(new Color(0xDDDDDD));
        chart.getStyler()
                .setLocale(Locale.ROOT)
                .setChartBackgroundColor(Color.WHITE)
                .setLegendPosition(Styler.LegendPosition.OutsideE)
                .setLegendBorderColor(Color.WHITE)
                .setMarkerSize(6);
    }

    /** Adds a line; a point that is no number above 0 is left out, and so is a line without points. */
    Chart line(String name, int colour, int stroke, List<Integer> circles, List<String> values) {
        List<Number> x = new ArrayList<>();
        List<Number> y = new ArrayList<>();
        for (int i = 0; i < circles.size(); i++) {
            double value = number(values.get(i));
            if (value > 0) {
                x.add(circles.get(i));
                y.add(value);
                across.take(circles.get(i));
                up.take(value);
            }
        }
        if (!x.isEmpty()) {
            XYSeries series = chart.addSeries(name, x, y);
            series.setLineColor(COLOURS[colour % COLOURS.length]).setLineStyle(STROKES[stroke % STROKES.length]);
            series.setMarker(MARKERS[stroke % MARKERS.length]).setMarkerColor(COLOURS[colour % COLOURS.length]);
        }
        return this;
    }

    private static double number(String value) {
        try {
            return Double.parseDouble(value);
        } catch (NumberFormatException e) {
            return 0;
        }
    }

    /**
     * Writes the picture. Where this Java cannot draw (one without fonts, say) it prints why; {@code --draw} does it later, on another
     * machine.
     */
    void save(Path file) throws IOException {
        if (up.most == 0) {
            return;
        }
        chart.getStyler()
                .setXAxisMin(across.below())
                .setXAxisMax(across.above())
                .setYAxisMin(up.below())
                .setYAxisMax(up.above());
        try {
            Files.createDirectories(file.toAbsolutePath().getParent());
            ImageIO.write(BitmapEncoder.getBufferedImage(chart), "png", file.toFile());
        } catch (RuntimeException | LinkageError | InternalError | AWTError e) {
            System.out.println("no " + file.getFileName() + ": " + e + "; draw it elsewhere with --draw --out FOLDER");
        }
    }
}
