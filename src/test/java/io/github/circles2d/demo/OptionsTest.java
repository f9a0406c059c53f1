package io.github.circles2d.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class OptionsTest {

    @Test
    void theDefaultIsTheThesisTestProgram() {
        Options options = Options.parse();
        Setup setup = options.setup(ComputeDevice.host());
        assertEquals(
                new Setup(
                        Scene.THESIS,
                        1250,
                        Solver.SMALL_STEPS,
                        0,
                        IndexStrategy.grid(),
                        CollisionStore.COMPACT,
                        ComputeDevice.host()),
                setup);
        assertFalse(options.headless || options.list || options.help);
        assertEquals(0, options.windowSteps());
        assertNull(options.windowPicture());
        assertEquals(1200, options.headlessSteps());
    }

    @Test
    void everyOptionIsRead() {
        Options options = Options.parse(
                "--scene gas --circles 7 --steps 9 --device host --solver impulse --strategy pair_table --store triangle --headless --list"
                        .split(" "));
        assertEquals(
                new Setup(
                        Scene.GAS,
                        7,
                        Solver.IMPULSE,
                        0,
                        IndexStrategy.pairTable(),
                        CollisionStore.TRIANGLE,
                        ComputeDevice.host()),
                options.setup(options.device()));
        assertTrue(options.headless && options.list);
        assertEquals(9, options.headlessSteps());
        assertEquals(9, options.windowSteps());
    }

    @Test
    void theStrategyMayBeLeftToTheWorld() {
        assertSame(IndexStrategy.auto(), Options.parse("--strategy", "auto").strategy());
    }

    @Test
    void aScreenshotEndsTheWindow() {
        Options options = Options.parse("--screenshot", "a/b.PNG");
        assertEquals(1200, options.windowSteps());
        assertEquals(Path.of("a/b.PNG"), options.windowPicture());
        assertEquals(Path.of("a/b.PNG"), options.headlessPicture(Path.of("")));
    }

    @Test
    void theHeadlessPictureGoesToTargetWhereThereIsOne(@TempDir Path folder) throws IOException {
        Options options = Options.parse();
        assertEquals(folder.resolve("circles2d.png"), options.headlessPicture(folder));
        Path target = Files.createDirectory(folder.resolve("target"));
        assertEquals(target.resolve("circles2d.png"), options.headlessPicture(folder));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--circle 5 | unknown option --circle",
                "5 | unknown option 5",
                "--circles | --circles needs a value",
                "--headless --steps | --steps needs a value",
                "--circles 0 | --circles = 0: must be a whole number from 1 to",
                "--circles 2.5 | --circles = 2.5: must be a whole number from 1 to",
                "--steps -1 | --steps = -1: must be a whole number from 1 to 10000000",
                "--steps 99999999999 | --steps = 99999999999: must be a whole number",
                "--scene moon | scene = moon: must be one of [thesis, gas, pile, mixed, pebbles, column, loaded, bullets, dam]",
                "--strategy tree | strategy = tree: must be one of [formula, pair_table, row_search, grid, folded, auto]",
                "--store heap | store = heap: must be one of [compact, triangle]",
                "--screenshot a.gif | --screenshot = a.gif: must end in .png",
            })
    void whatIsWrongIsNamed(String line, String message) {
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class, () -> Options.parse(line.split(" ")));
        assertTrue(e.getMessage().startsWith(message), e.getMessage());
    }

    @Test
    void anUnknownDeviceIsNamed() {
        Options options = Options.parse("--device", "abacus");
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class, options::device);
        assertEquals("--device = abacus: no such device; --list shows those of this machine", e.getMessage());
    }
}
