package io.github.circles2d.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
class WindowTest {
    private static final PrintStream NOWHERE = new PrintStream(PrintStream.nullOutputStream());

    @BeforeAll
    static void needsADisplay() {
        if (GraphicsEnvironment.isHeadless()) {
            System.err.println("WindowTest is skipped: there is no display (run under xvfb-run)");
        }
        Assumptions.assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
    }

    private static Setup setup(int circles, CollisionStore store) {
        return new Setup(Scene.GAS, circles, IndexStrategy.folded(), store, ComputeDevice.host());
    }

    @Test
    void savesItsPictureAfterItsSteps(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("window.png");
        Window window = Window.open(setup(50, CollisionStore.COMPACT), 10);
        assertTrue(window.run(file, NOWHERE, NOWHERE));
        BufferedImage picture = ImageIO.read(file.toFile());
        int bright = 0;
        for (int y = 100; y < picture.getHeight() - 100; y++) {
            for (int x = 100; x < picture.getWidth() - 100; x++) {
                bright += PainterTest.brightness(PainterTest.pixel(picture, x, y)) > 200 ? 1 : 0;
            }
        }
        assertTrue(bright > 10_000, bright + " bright pixels");
    }

    @Test
    void endsWhenItIsClosed() throws Exception {
        Window window = Window.open(setup(50, CollisionStore.COMPACT), 0);
        EventQueue.invokeLater(
                () -> window.frame().dispatchEvent(new WindowEvent(window.frame(), WindowEvent.WINDOW_CLOSING)));
        assertTrue(window.run(null, NOWHERE, NOWHERE));
        assertFalse(window.frame().isDisplayable());
    }

    @Test
    void aFailureEndsARunWithALimit(@TempDir Path folder) throws Exception {
        Window window = Window.open(setup(200_000, CollisionStore.TRIANGLE), 10);
        Path file = folder.resolve("window.png");
        assertFalse(window.run(file, NOWHERE, NOWHERE));
        assertEquals(0, folder.toFile().list().length);
    }
}
