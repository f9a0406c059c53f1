package io.github.circles2d.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.Circles2DException;
import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
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

    private static final Scene BROKEN = new Scene("broken", 0, 0, 0, (world, circles) -> {
        throw new Circles2DException("the device is gone");
    });

    private static Setup setup(Scene scene) {
        return new Setup(
                scene, 50, Solver.IMPULSE, 0, IndexStrategy.folded(), CollisionStore.COMPACT, ComputeDevice.host());
    }

    private static void close(Window window) {
        EventQueue.invokeLater(
                () -> window.frame().dispatchEvent(new WindowEvent(window.frame(), WindowEvent.WINDOW_CLOSING)));
    }

    @Test
    void savesItsPictureAfterItsSteps(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("window.png");
        Window window = Window.open(setup(Scene.GAS), 10);
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
        Window window = Window.open(setup(Scene.GAS), 0);
        close(window);
        assertTrue(window.run(null, NOWHERE, NOWHERE));
        assertFalse(window.frame().isDisplayable());
    }

    @Test
    void aFailureEndsARunWithALimit(@TempDir Path folder) throws Exception {
        Window window = Window.open(setup(BROKEN), 10);
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        assertFalse(window.run(folder.resolve("window.png"), NOWHERE, new PrintStream(err, true)));
        assertEquals("the device is gone" + System.lineSeparator(), err.toString());
        assertEquals(0, folder.toFile().list().length);
    }
}
