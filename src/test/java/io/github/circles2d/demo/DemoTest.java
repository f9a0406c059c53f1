package io.github.circles2d.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.Circles2D;
import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Snapshot;
import io.github.circles2d.Solver;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DemoTest {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    private int demo(String... arguments) throws Exception {
        return Demo.run(print(out), print(err), arguments);
    }

    private static PrintStream print(ByteArrayOutputStream to) {
        return new PrintStream(to, true, StandardCharsets.UTF_8);
    }

    @Test
    void aHeadlessRunShowsTheCirclesOfTheScene(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("new/folder/gas.png");
        String line = "--headless --scene gas --circles 200 --steps 60 --device host --screenshot " + file;
        assertEquals(0, demo(line.split(" ")), err::toString);

        double area = 0;
        String hash;
        try (Circles2D world = Scene.GAS.build(Circles2D.builder().device(ComputeDevice.host()), 200)) {
            world.step(60);
            hash = String.format("%016x", world.stateHash());
            Snapshot now = world.snapshot();
            double side = ImageIO.read(file.toFile()).getWidth() - 24;
            for (int slot = 0; slot < now.count(); slot++) {
                area += Math.PI * Math.pow(side * now.radius(slot), 2);
            }
        }
        assertEquals(area, PainterTest.painted(ImageIO.read(file.toFile())), 0.1 * area);
        String summary = out.toString(StandardCharsets.UTF_8);
        assertTrue(summary.contains("hash      " + hash), summary);
        assertTrue(summary.contains("device    host"), summary);
        assertTrue(summary.contains("picture   " + file), summary);
        assertEquals("", err.toString(StandardCharsets.UTF_8));
    }

    @Test
    void strategyAndStoreDoNotChangeTheSummarysHash(@TempDir Path folder) {
        Path file = folder.resolve("a.png");
        Setup compact = new Setup(
                Scene.THESIS,
                200,
                Solver.IMPULSE,
                0,
                IndexStrategy.folded(),
                CollisionStore.COMPACT,
                ComputeDevice.host());
        Setup triangle = new Setup(
                Scene.THESIS,
                200,
                Solver.IMPULSE,
                0,
                IndexStrategy.rowSearch(),
                CollisionStore.TRIANGLE,
                ComputeDevice.host());
        SimulationRun.Summary a = SimulationRun.run(compact, 20, file, print(out));
        SimulationRun.Summary b = SimulationRun.run(triangle, 20, file, print(out));
        assertEquals(a.hash(), b.hash());
        assertEquals(a.contacts(), b.contacts());
        assertTrue(a.contacts() > 0 && a.medianMillis() > 0 && a.slowMillis() >= a.medianMillis(), a.toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"--nonsense", "--circles", "--circles many", "--device abacus"})
    void aWrongCommandLineIsStatusTwo(String line) throws Exception {
        assertEquals(2, demo(line.split(" ")));
        String message = err.toString(StandardCharsets.UTF_8);
        assertTrue(message.contains(line.split(" ")[0]) && message.contains("--help"), message);
        assertEquals("", out.toString(StandardCharsets.UTF_8));
    }

    @Test
    void aPictureThatCannotBeWrittenIsStatusOneBeforeAnyStep(@TempDir Path folder) throws Exception {
        Path file = Files.writeString(folder.resolve("file"), "").resolve("a.png");
        assertEquals(1, demo("--headless", "--device", "host", "--screenshot", file.toString()));
        String message = err.toString(StandardCharsets.UTF_8);
        assertTrue(message.startsWith("cannot write the picture " + file), message);
        assertEquals("", out.toString(StandardCharsets.UTF_8));
    }

    @Test
    void aPreferredDeviceThatIsNotThereIsStatusOne() throws Exception {
        String before = System.getProperty(ComputeDevice.PROPERTY);
        System.setProperty(ComputeDevice.PROPERTY, "abacus");
        try {
            assertEquals(1, demo("--headless"));
        } finally {
            if (before == null) {
                System.clearProperty(ComputeDevice.PROPERTY);
            } else {
                System.setProperty(ComputeDevice.PROPERTY, before);
            }
        }
        String message = err.toString(StandardCharsets.UTF_8);
        assertTrue(message.startsWith("no device \"abacus\""), message);
    }

    @Test
    void helpAndListSayWhatThereIs() throws Exception {
        assertEquals(0, demo("--help"));
        assertTrue(out.toString(StandardCharsets.UTF_8).contains("--screenshot FILE"));
        out.reset();
        assertEquals(0, demo("--list"));
        String list = out.toString(StandardCharsets.UTF_8);
        assertTrue(list.contains("HOST") && list.contains("deterministic"), list);
    }
}
