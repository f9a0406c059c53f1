package io.github.circles2d.opencl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.TestDevices;
import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Population;
import io.github.circles2d.pipeline.SmallSteps;
import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.stream.Stream;
import org.jocl.Pointer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The parts of the heap stay apart, and keep what is in them when it grows. */
class HeapTest {
    private static final WorldConfig CONFIG = SmallSteps.box(1, 0);

    private Session session;
    private State state;
    private Heap heap;

    @BeforeEach
    void open() {
        session = new Session((OpenClDevice) TestDevices.openClInside());
        state = new State(session);
        heap = new Heap(session);
        ensure(10);
    }

    @AfterEach
    void close() {
        if (session != null) {
            session.close();
        }
    }

    private void ensure(int circles) {
        FloatBuffer transforms = FloatBuffer.allocate(4 * circles);
        for (int i = 0; i < circles; i++) {
            transforms.put(4 * i + 2, 0.01f);
        }
        Levels[] levels = Levels.all(CONFIG, Population.of(transforms, null, circles));
        heap.ensureCircles(levels, circles);
        heap.write(levels, Stream.of(levels).map(Tiles::of).toArray(Tiles[]::new));
    }

    private DeviceBuffer buffer() {
        return (DeviceBuffer) heap.world(0, 0, state)[0];
    }

    @Test
    void whoWritesBeyondAPartIsSeen() {
        assertTrue(heap.intact());
        // the first part is that of ten circles and 1,054 contacts, 12 bytes each
        buffer().fill(0, 12 * 1056, Pointer.to(new int[] {7}));
        assertTrue(heap.intact());
        buffer().fill(0, 12 * 1056 + 4, Pointer.to(new int[] {7}));
        assertFalse(heap.intact());
    }

    @Test
    void aHeapThatGrowsKeepsItsParts() {
        int part = Heap.LIST_START;
        buffer().fill(32L * heap.at(1, part), 44, Pointer.to(new int[] {41}));
        ensure(1000);
        heap.ensureContacts(100_000);
        IntBuffer list =
                ByteBuffer.allocateDirect(48).order(ByteOrder.nativeOrder()).asIntBuffer();
        buffer().read(32L * heap.at(1, part), list, 48);
        assertEquals(41, list.get(0));
        assertEquals(41, list.get(10));
        assertTrue(heap.intact());
    }
}
