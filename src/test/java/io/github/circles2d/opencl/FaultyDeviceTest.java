package io.github.circles2d.opencl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.CapacityException;
import io.github.circles2d.Circles2D;
import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Internals;
import io.github.circles2d.KernelBuildException;
import io.github.circles2d.StepStats;
import io.github.circles2d.TestDevices;
import io.github.circles2d.ThrowingStrategy;
import io.github.circles2d.pipeline.Tuning;
import java.lang.reflect.Proxy;
import java.nio.ByteBuffer;
import java.util.List;
import org.jocl.CL;
import org.jocl.cl_mem;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A device that is too small, a source that does not compile, an application that has turned JOCL's exceptions on. */
class FaultyDeviceTest {
    private FaultyClApi faulty;

    @BeforeEach
    void openCl() {
        TestDevices.openCl();
        faulty = new FaultyClApi(JoclApi.load());
    }

    @AfterEach
    void nothingLeft() {
        CL.setExceptionsEnabled(false);
        assertEquals(List.of(), faulty.live());
        assertEquals(List.of(), faulty.misuses());
    }

    private ComputeDevice device() {
        return Internals.computeDevice(OpenClDevices.list(faulty.api()).get(0));
    }

    /** A user's strategy; this source and the mapping of the built-in one. */
    private record Users(String kernelSource) implements IndexStrategy {
        @Override
        public String name() {
            return "users";
        }

        @Override
        public long pairAt(long pair, long first, int circles, ByteBuffer table) {
            return IndexStrategy.folded().pairAt(pair, first, circles, table);
        }
    }

    @Test
    void aBufferLargerThanTheDeviceAllowsIsRefusedWithNumbers() {
        faulty.limit(CL.CL_DEVICE_MAX_MEM_ALLOC_SIZE, 1_000_000);
        tooMuch(100_000, "state takes \\d+ bytes; .* allows 1000000 in one buffer and \\d+ in all.*");
    }

    @Test
    void moreInAllThanTheDeviceHasIsRefusedWithNumbers() {
        faulty.limit(CL.CL_DEVICE_GLOBAL_MEM_SIZE, 2_000_000);
        tooMuch(100_000, "state takes \\d+ bytes; .* and 2000000 in all, \\d+ of which.*");
    }

    private void tooMuch(int circles, String message) {
        try (Circles2D world = Internals.thesis().device(device()).build()) {
            world.addCircle(0.5f, 0.5f, 0.1f, 1);
            world.addCircle(0.6f, 0.5f, 0.1f, 1);
            world.step();
            long before = world.stateHash();
            StepStats stats = world.stats();
            for (int i = 2; i < circles; i++) {
                world.addCircle(0.5f, 0.5f, 0.001f, 1);
            }
            faulty.behave();
            for (int attempt = 0; attempt < 3; attempt++) {
                CapacityException e = assertThrows(CapacityException.class, world::step);
                assertTrue(e.getMessage().matches(message), e.getMessage());
            }
            assertFalse(faulty.calls().contains("enqueueNDRangeKernel"), "a step began");
            assertEquals(circles, world.snapshot().count());
            assertEquals(stats.contacts(), world.stats().contacts());
            assertFalse(before == world.stateHash(), "the circles that were added are there");
        }
    }

    @Test
    void memoryOfARefusedTriangleIsGivenBack() {
        faulty.limit(CL.CL_DEVICE_GLOBAL_MEM_SIZE, 1_000_000);
        Circles2D.Builder builder = Internals.thesis(0, 20_000, 0)
                .device(device())
                .capacity(1000)
                .indexStrategy(IndexStrategy.pairTable())
                .collisionStore(CollisionStore.TRIANGLE);
        try (Circles2D world = builder.build()) {
            for (int i = 0; i < 700; i++) {
                world.addCircle(0.5f, 0.5f, 0.001f, 1);
            }
            String first = assertThrows(CapacityException.class, world::step).getMessage();
            int live = faulty.live().size();
            for (int attempt = 0; attempt < 20; attempt++) {
                assertEquals(
                        first,
                        assertThrows(CapacityException.class, world::step).getMessage());
            }
            assertEquals(live, faulty.live().size());
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aSourceThatDoesNotCompileIsShownWithItsOwnLine(boolean exceptions) {
        ComputeDevice device = device();
        CL.setExceptionsEnabled(exceptions);
        Circles2D.Builder builder = Internals.thesis()
                .device(device)
                .indexStrategy(new Users("static int2 c2d_pair_at(c2d_index pair, c2d_index first, int circles,\n"
                        + "                        __global const int2 *table) {\n    return nonsense;\n}\n"));
        KernelBuildException e = assertThrows(KernelBuildException.class, builder::build);
        assertTrue(e.log().contains("index_users.cl:3"), e.log());
        assertTrue(e.getMessage().contains("index_users.cl:3"), e.getMessage());
        assertTrue(e.getMessage().contains("-cl-std=CL1.2"), e.getMessage());
        assertTrue(e.getMessage().contains(device.name()), e.getMessage());
    }

    @Test
    void aBuildFailureIsOneEvenWhereTheDriverHasNoLog() {
        ComputeDevice device = device();
        Circles2D.Builder builder = Internals.thesis().device(device).indexStrategy(new Users("nonsense"));
        faulty.behave();
        assertThrows(KernelBuildException.class, builder::build);
        int log = faulty.calls().indexOf("getProgramBuildInfo");
        faulty.fail(log, -30, false);
        KernelBuildException e = assertThrows(KernelBuildException.class, builder::build);
        assertTrue(e.getMessage().contains("clGetProgramBuildInfo"), e.getMessage());
    }

    /** As often as that, builds fail and have nothing to say. */
    private ComputeDevice silent(int fails, int[] builds) {
        ClApi api = (ClApi) Proxy.newProxyInstance(
                ClApi.class.getClassLoader(), new Class<?>[] {ClApi.class}, (proxy, method, arguments) -> {
                    if (method.getName().equals("buildProgram") && builds[0]++ < fails) {
                        return CL.CL_BUILD_PROGRAM_FAILURE;
                    }
                    // an empty log
                    return method.getName().equals("getProgramBuildInfo") ? 0 : method.invoke(faulty.api(), arguments);
                });
        return Internals.computeDevice(OpenClDevices.list(api).get(0));
    }

    @Test
    void aBuildThatFailsWithoutAWordIsTriedAgain() {
        int[] builds = {0};
        Circles2D.Builder builder = Internals.thesis().device(silent(Tuning.BUILDS - 1, builds));
        builder.build().close();
        int first = builds[0];
        builder.build().close();
        assertEquals(builds[0] - first + Tuning.BUILDS - 1, first);
    }

    @Test
    void aBuildThatNeverSaysWhyIsGivenUp() {
        int[] builds = {0};
        Circles2D.Builder builder = Internals.thesis().device(silent(Integer.MAX_VALUE, builds));
        assertThrows(KernelBuildException.class, builder::build);
        assertEquals(Tuning.BUILDS, builds[0]);
    }

    @Test
    void aStrategyWhoseTableThrowsLosesNothing() {
        IndexStrategy users = new ThrowingStrategy(new ArithmeticException("the user's own"));
        try (Circles2D world =
                Internals.thesis().device(device()).indexStrategy(users).build()) {
            world.addCircle(0.5f, 0.5f, 0.1f, 1);
            world.addCircle(0.6f, 0.5f, 0.1f, 1);
            assertEquals(
                    "the user's own",
                    assertThrows(ArithmeticException.class, world::step).getMessage());
            assertEquals(2, world.snapshot().count());
        }
    }

    @Test
    void joclsExceptionsBecomeStatuses() {
        ClApi api = JoclApi.load();
        CL.setExceptionsEnabled(true);
        OpenClDevice device = OpenClDevices.list(api).get(0);
        try (Session session = new Session(device)) {
            int[] status = new int[1];
            cl_mem none = api.createBuffer(session.context, CL.CL_MEM_READ_WRITE, 1L << 60, status);
            assertNull(none);
            assertEquals(CL.CL_INVALID_BUFFER_SIZE, status[0]);
            assertEquals(CL.CL_INVALID_MEM_OBJECT, api.releaseMemObject(null));
            assertEquals(CL.CL_INVALID_COMMAND_QUEUE, api.finish(null));
            assertEquals(CL.CL_INVALID_COMMAND_QUEUE, api.flush(null));
            assertEquals(CL.CL_INVALID_CONTEXT, api.releaseContext(null));
            assertEquals(CL.CL_INVALID_KERNEL, api.releaseKernel(null));
            assertEquals(CL.CL_INVALID_PROGRAM, api.releaseProgram(null));
            assertEquals(CL.CL_INVALID_COMMAND_QUEUE, api.enqueueUnmapMemObject(null, null, null));
            assertNull(api.enqueueMapBuffer(null, null, CL.CL_MAP_READ, 16, status));
            assertEquals(CL.CL_INVALID_COMMAND_QUEUE, status[0]);
            assertNull(api.createKernel(null, "c2d_update", status));
            assertEquals(CL.CL_INVALID_PROGRAM, status[0]);
            assertNull(api.createSubBuffer(null, CL.CL_MEM_READ_WRITE, 0, 16, status));
            assertEquals(CL.CL_INVALID_MEM_OBJECT, status[0]);
        }
    }

    @Test
    void aWorldRunsWhereTheApplicationHasTurnedJoclsExceptionsOn() {
        ComputeDevice device = device();
        long expected = run(device);
        CL.setExceptionsEnabled(true);
        assertEquals(expected, run(device));
        assertTrue(device.deterministic());
    }

    private static long run(ComputeDevice device) {
        try (Circles2D world = Internals.thesis().device(device).build()) {
            world.addCircle(0.5f, 0.5f, 0.1f, 1);
            world.addCircle(0.6f, 0.5f, 0.1f, 1);
            world.step(5);
            return world.stateHash();
        }
    }
}
