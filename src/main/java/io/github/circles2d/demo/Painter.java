package io.github.circles2d.demo;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;

/**
 * Paints circles into a picture, antialiased, dark to light by mass. It computes the pixels itself: that is faster than
 * Java2D's ovals, the same on every machine, and works where AWT has no display or failed to open it.
 */
final class Painter {
    static final int BACKGROUND = 0x0A0E12;

    /** The masses that the scenes use, and that the colours span. */
    static final float LIGHTEST = 1;

    static final float HEAVIEST = 10;

    private static final int OUTSIDE = 0x14191F;
    private static final int WALL = 0x2C3742;
    /** From the lightest circle to the heaviest. */
    private static final int[] RAMP = {0x12464F, 0x1C7A80, 0x38B2A8, 0x8ED9B8, 0xE9F7D0};

    private static final int[] COLOURS = colours();

    /** Pixels around the box. */
    private static final int MARGIN = 12;

    /** How much darker a circle is at its rim than inside, so that circles that touch stay apart to the eye. */
    private static final float RIM = 0.45f;

    private Painter() {}

    /** A picture for {@link #paint}. */
    static BufferedImage picture(int width, int height) {
        return new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    }

    /** Paints the box and its circles, as large as they fit, into a {@link #picture}. */
    static void paint(Frame frame, BufferedImage picture) {
        int width = picture.getWidth();
        int height = picture.getHeight();
        int side = Math.max(1, Math.min(width, height) - 2 * MARGIN);
        int left = (width - side) / 2;
        int top = (height - side) / 2;
        int[] pixels = ((DataBufferInt) picture.getRaster().getDataBuffer()).getData();
        Arrays.fill(pixels, OUTSIDE);
        fill(pixels, width, height, left - 1, top - 1, side + 2, WALL);
        fill(pixels, width, height, left, top, side, BACKGROUND);
        float[] circles = frame.circles();
        for (int at = 0; at < circles.length; at += 4) {
            float x = left + side * circles[at];
            float y = top + side * (1 - circles[at + 1]);
            disc(pixels, width, height, x, y, side * circles[at + 2], colour(circles[at + 3]));
        }
    }

    /** The colour of a mass. */
    static int colour(float mass) {
        float t = (mass - LIGHTEST) / (HEAVIEST - LIGHTEST);
        return COLOURS[(int) (Math.min(Math.max(t, 0), 1) * (COLOURS.length - 1))];
    }

    private static int[] colours() {
        int[] colours = new int[256];
        for (int k = 0; k < colours.length; k++) {
            float t = k * (RAMP.length - 1) / (float) (colours.length - 1);
            int from = Math.min((int) t, RAMP.length - 2);
            colours[k] = mix(RAMP[from], RAMP[from + 1], t - from);
        }
        return colours;
    }

    private static void fill(int[] pixels, int width, int height, int left, int top, int side, int colour) {
        int right = Math.min(width, left + side);
        for (int y = Math.max(0, top); y < Math.min(height, top + side); y++) {
            Arrays.fill(pixels, y * width + Math.max(0, left), y * width + right, colour);
        }
    }

    private static void disc(int[] pixels, int width, int height, float x, float y, float radius, int colour) {
        float reach = radius + 0.5f;
        float rim = Math.min(1.6f, radius / 4);
        float plain = Math.max(0, radius - 2 * rim);
        int right = (int) Math.min(width - 1f, x + reach);
        int bottom = (int) Math.min(height - 1f, y + reach);
        for (int row = (int) Math.max(0, y - reach); row <= bottom; row++) {
            float dy = row + 0.5f - y;
            for (int column = (int) Math.max(0, x - reach); column <= right; column++) {
                float dx = column + 0.5f - x;
                float square = dx * dx + dy * dy;
                int at = row * width + column;
                if (square < plain * plain) {
                    pixels[at] = colour;
                } else if (square < reach * reach) {
                    float distance = (float) Math.sqrt(square);
                    float dark = Math.min(Math.max((distance - plain) / (2 * rim), 0), 1);
                    float cover = Math.min(reach - distance, 1);
                    pixels[at] = mix(pixels[at], mix(colour, BACKGROUND, RIM * dark), cover);
                }
            }
        }
    }

    /** {@code t} = 0 gives {@code a}, 1 gives {@code b}. In eighths: the eye does not see it, and PNGs shrink to a third. */
    private static int mix(int a, int b, float t) {
        int weight = Math.round(8 * t);
        int redBlue = (a & 0xFF00FF) * (8 - weight) + (b & 0xFF00FF) * weight >>> 3 & 0xFF00FF;
        int green = (a & 0x00FF00) * (8 - weight) + (b & 0x00FF00) * weight >>> 3 & 0x00FF00;
        return redBlue | green;
    }
}
