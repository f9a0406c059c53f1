package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.demo.Scene;
import io.github.circles2d.pipeline.Tuning;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class SnapshotTest {
    private static Circles2D world(ComputeDevice device, int circles) {
        Circles2D world = Circles2D.builder().device(device).capacity(circles).build();
        for (int i = 0; i < circles; i++) {
            world.addCircle(0.1f + 0.2f * i, 0.5f, 0.05f + 0.001f * i, 1 + i);
        }
        return world;
    }

    private static void checkBuffer(FloatBuffer buffer, int limit) {
        assertTrue(buffer.isDirect(), "direct");
        assertTrue(buffer.isReadOnly(), "read-only");
        assertEquals(ByteOrder.nativeOrder(), buffer.order());
        assertEquals(0, buffer.position());
        assertEquals(limit, buffer.limit());
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void buffersHoldWhatTheMethodsSay(Supplier<ComputeDevice> device) {
        try (Circles2D world = world(device.get(), 4)) {
            world.setVelocity(2, 0.25f, -0.5f);
            for (int step = 0; step < 3; step++) {
                Snapshot now = world.snapshot();
                assertEquals(4, now.count());
                FloatBuffer transforms = now.transforms();
                FloatBuffer velocities = now.velocities();
                checkBuffer(transforms, 16);
                checkBuffer(velocities, 8);
                for (int slot = 0; slot < 4; slot++) {
                    assertEquals(now.x(slot), transforms.get());
                    assertEquals(now.y(slot), transforms.get());
                    assertEquals(now.radius(slot), transforms.get());
                    assertEquals(0f, transforms.get());
                    assertEquals(now.vx(slot), velocities.get());
                    assertEquals(now.vy(slot), velocities.get());
                    assertEquals(1 + slot, now.mass(slot));
                    assertEquals(slot, now.circleAt(slot));
                }
                // a caller that leaves them read to the end finds them at the start again
                checkBuffer(now.transforms(), 16);
                checkBuffer(now.velocities(), 8);
                world.step();
            }
        }
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void sameObjectRefreshed(Supplier<ComputeDevice> device) {
        try (Circles2D world = world(device.get(), 2)) {
            Snapshot first = world.snapshot();
            FloatBuffer transforms = first.transforms();
            FloatBuffer velocities = first.velocities();
            float y = first.y(0);
            world.step();
            assertSame(first, world.snapshot());
            assertNotEquals(y, first.y(0));
            assertSame(transforms, first.transforms());
            assertSame(velocities, first.velocities());
            assertEquals(first.y(0), transforms.get(1));
            assertEquals(first.vy(0), velocities.get(1));
        }
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void slotsOutOfRange(Supplier<ComputeDevice> device) {
        // room for more than there are
        try (Circles2D world =
                Circles2D.builder().device(device.get()).capacity(100).build()) {
            world.addCircle(0.5f, 0.5f, 0.1f, 1);
            Snapshot now = world.snapshot();
            IntConsumer[] getters = {now::x, now::y, now::radius, now::mass, now::vx, now::vy, now::circleAt};
            for (IntConsumer getter : getters) {
                getter.accept(0);
                for (int bad : new int[] {-1, 1, 99, 1 << 30, Integer.MAX_VALUE, Integer.MIN_VALUE}) {
                    assertThrows(IndexOutOfBoundsException.class, () -> getter.accept(bad));
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void readableAfterClose(Supplier<ComputeDevice> device) {
        Circles2D world = world(device.get(), 3);
        world.step(5);
        Snapshot last = world.snapshot();
        float y = last.y(2);
        world.close();
        assertEquals(3, last.count());
        assertEquals(y, last.y(2));
        assertEquals(y, last.transforms().get(9));
    }

    /** A state that comes back from an OpenCL device in more than one part. */
    @Test
    void aLargeWorldComesBackWhole() {
        int circles = Tuning.STAGING_BYTES / 16 + 1000;
        assertEquals(large(ComputeDevice.host(), circles), large(TestDevices.openCl(), circles));
    }

    private static long large(ComputeDevice device, int circles) {
        // by the solver that takes less memory: PoCL allows a quarter of the machine's for one buffer
        Circles2D.Builder builder =
                Circles2D.builder().device(device).solver(Solver.IMPULSE).capacity(circles);
        try (Circles2D world = Scene.GAS.build(builder, circles)) {
            long before = world.stateHash();
            world.step();
            long after = world.stateHash();
            assertNotEquals(before, after);
            FloatBuffer transforms = world.snapshot().transforms();
            for (int slot = 0; slot < circles; slot++) {
                assertEquals(0f, transforms.get(4 * slot + 3));
            }
            return after;
        }
    }
}
