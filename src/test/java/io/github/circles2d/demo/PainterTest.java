package io.github.circles2d.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;

class PainterTest {

    @Test
    void yGoesUpAndXGoesRight() {
        BufferedImage picture = paint(200, 200, 0.8f, 0.9f, 0.05f, 5);
        // 12 pixels of margin around a box of 176
        assertEquals(Painter.colour(5), pixel(picture, 12 + 141, 12 + 17));
        assertEquals(Painter.BACKGROUND, pixel(picture, 12 + 141, 12 + 158));
        assertEquals(Painter.BACKGROUND, pixel(picture, 12 + 35, 12 + 17));
    }

    @Test
    void theBoxStaysSquareInTheMiddle() {
        BufferedImage picture = paint(400, 200, 0.5f, 0.5f, 0.5f, 5);
        assertEquals(Painter.colour(5), pixel(picture, 200, 100));
        assertNotEquals(Painter.BACKGROUND, pixel(picture, 110, 22), "outside of the box");
        assertEquals(Painter.BACKGROUND, pixel(picture, 113, 13), "a corner of the box");
        assertEquals(Painter.BACKGROUND, pixel(picture, 287, 187), "a corner of the box");
    }

    @Test
    void aDiscCoversItsArea() {
        BufferedImage picture = paint(424, 424, 0.37f, 0.61f, 0.1f, Painter.HEAVIEST);
        double area = Math.PI * 40 * 40;
        assertEquals(area, painted(picture), 0.03 * area);
    }

    @Test
    void heavierIsLighter() {
        for (float mass = 1; mass < 10; mass++) {
            assertTrue(brightness(Painter.colour(mass)) < brightness(Painter.colour(mass + 1)), "mass " + mass);
        }
        assertEquals(Painter.colour(10), Painter.colour(1e9f));
        assertEquals(Painter.colour(1), Painter.colour(1e-9f));
    }

    @Test
    void whatLiesOutsideOrIsNoNumberIsClipped() {
        float nan = Float.NaN;
        float[][] odd = {
            {-3, 0.5f, 0.1f, 1}, {0.5f, 7, 0.1f, 1}, {1e30f, -1e30f, 1, 1}, {nan, nan, 0.1f, 1}, {0, 0, 5, nan}
        };
        for (float[] circle : odd) {
            paint(64, 48, circle);
            paint(1, 1, circle);
        }
    }

    private static BufferedImage paint(int width, int height, float... circle) {
        BufferedImage picture = Painter.picture(width, height);
        Painter.paint(new Frame(circle), picture);
        return picture;
    }

    static int pixel(BufferedImage picture, int x, int y) {
        return picture.getRGB(x, y) & 0xFFFFFF;
    }

    static int brightness(int colour) {
        return (colour >> 16) + (colour >> 8 & 255) + (colour & 255);
    }

    /** Pixels inside the box of a square picture that show a circle; those half covered count, those less do not. */
    static int painted(BufferedImage picture) {
        int least = (brightness(Painter.BACKGROUND) + brightness(Painter.colour(Painter.LIGHTEST))) / 3;
        int painted = 0;
        for (int y = 12; y < picture.getHeight() - 12; y++) {
            for (int x = 12; x < picture.getWidth() - 12; x++) {
                painted += brightness(pixel(picture, x, y)) > least ? 1 : 0;
            }
        }
        return painted;
    }
}
