package io.github.circles2d.opencl;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.Circles2D;
import io.github.circles2d.Circles2DException;
import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Internals;
import io.github.circles2d.OpenClException;
import io.github.circles2d.Snapshot;
import io.github.circles2d.TestDevices;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Every OpenCL call fails once, and again with all calls after it, for every status a driver is known to give. */
class FaultTest {
    /** No memory, no resources, no host memory, a queue that died, a size that is too large. */
    private static final List<Integer> STATUSES = List.of(-4, -5, -6, -36, -61);

    private static final List<Function<Circles2D, Object>> USE = List.of(
            FaultTest::addPile,
            FaultTest::step,
            world -> world.snapshot().x(7),
            FaultTest::stats,
            world -> world.addCircle(0.2f, 0.7f, 0.05f, 2),
            FaultTest::step,
            Circles2D::stateHash,
            FaultTest::stats);

    private LogCapture log;
    private FaultyClApi faulty;
    private ComputeDevice device;

    @BeforeEach
    void device() {
        TestDevices.openCl();
        log = new LogCapture();
        faulty = new FaultyClApi(JoclApi.load());
        device = Internals.computeDevice(OpenClDevices.list(faulty.api()).get(0));
    }

    @AfterEach
    void restoreLog() {
        log.close();
    }

    /** More contacts than a world first has room for: a step stalls, and room is made. */
    private static Object addPile(Circles2D world) {
        for (int i = world.circleCount(); i < 56; i++) {
            world.addCircle(0.5f + 0.001f * i, 0.5f, 0.04f, 1 + i % 3);
        }
        return world.circleCount();
    }

    private static Object step(Circles2D world) {
        world.step(2);
        return "stepped";
    }

    private static Object stats(Circles2D world) {
        return world.stats();
    }

    /** Worlds that between them make every call. */
    enum World {
        ONE_GROUP,
        SLICES_OF_A_TRIANGLE,
        SMALL_STEPS,
        IN_BACKGROUND
    }

    private Circles2D.Builder builder(World kind) {
        return switch (kind) {
            case ONE_GROUP -> Internals.thesis(0, 0, 4096).device(device);
            case SLICES_OF_A_TRIANGLE ->
                Internals.thesis(0, 1000, 0)
                        .device(device)
                        .indexStrategy(IndexStrategy.pairTable())
                        .collisionStore(CollisionStore.TRIANGLE);
            case SMALL_STEPS -> Internals.builder(0, 0, 0).device(device).substeps(2);
            case IN_BACKGROUND ->
                Internals.builder(0, 0, 0).device(device).substeps(2).background(true);
        };
    }

    private List<Object> healthy(World kind) {
        faulty.behave();
        List<Object> results = new ArrayList<>();
        try (Circles2D world = builder(kind).build()) {
            USE.forEach(use -> results.add(use.apply(world)));
        }
        assertEquals(List.of(), faulty.live());
        assertEquals(List.of(), faulty.misuses());
        assertEquals(List.of(), log.take());
        return results;
    }

    @ParameterizedTest
    @EnumSource
    void anyOneCallMayFail(World kind) {
        List<Object> expected = healthy(kind);
        List<String> calls = faulty.calls();
        assertTrue(calls.containsAll(Set.of("createContext", "buildProgram", "finish", "releaseContext")));
        Set<String> met = new HashSet<>();
        for (int k = 0; k < calls.size(); k++) {
            // every call with one status, the first of each kind with all of them
            boolean first = met.add(calls.get(k));
            boolean writes = calls.get(k).equals("enqueueWriteBuffer");
            if (!first && !writes && k % every(kind) != 0) {
                continue;
            }
            for (int s = 0; s < (first ? STATUSES.size() : 1); s++) {
                int status = STATUSES.get((k + s) % STATUSES.size());
                String fault = "call " + k + ", " + calls.get(k) + ", gives " + status;
                faulty.fail(k, status, false);
                failOnce(kind, expected, fault);
                if (first || k % 4 == 0) {
                    faulty.fail(k, status, true);
                    loseDevice(kind, fault);
                }
            }
        }
    }

    /** Launches and arguments of small steps are many and alike. */
    private static int every(World kind) {
        return kind == World.SMALL_STEPS ? 5 : kind == World.IN_BACKGROUND ? 11 : 1;
    }

    /** Says what happened, or does what it would have done without the fault. */
    private void failOnce(World kind, List<Object> expected, String fault) {
        Circles2DException first = null;
        boolean failed = false;
        Circles2D world = null;
        try {
            world = builder(kind).build();
        } catch (Circles2DException e) {
            first = e;
        }
        for (int i = 0; world != null && i < USE.size(); i++) {
            Function<Circles2D, Object> use = USE.get(i);
            Circles2D used = world;
            try {
                assertEquals(expected.get(i), use.apply(used), fault);
            } catch (Circles2DException e) {
                if (first == null) {
                    first = e;
                    // what fails before a step begins leaves the world as it was; then a second try does it
                    failed = !tryAgain(used, use, expected.get(i), first, fault);
                } else {
                    assertTrue(failed, fault + ", later: " + e);
                    assertSame(first, e.getCause(), fault);
                }
                continue;
            }
            assertFalse(failed, fault + ": a failed world goes on");
        }
        if (world != null) {
            assertDoesNotThrow(world::close, fault);
        }
        assertTrue(first != null || !log.take().isEmpty(), fault + " and nobody is told");
        log.take();
        assertNothingLeft(fault);
    }

    private static boolean tryAgain(
            Circles2D world, Function<Circles2D, Object> use, Object expected, Circles2DException first, String fault) {
        try {
            assertEquals(expected, use.apply(world), fault + ", second try");
            return true;
        } catch (Circles2DException e) {
            assertSame(first, e.getCause(), fault + ", second try: " + e);
            return false;
        }
    }

    private void loseDevice(World kind, String fault) {
        try (Circles2D world = builder(kind).build()) {
            for (Function<Circles2D, Object> use : USE) {
                try {
                    use.apply(world);
                } catch (Circles2DException e) {
                    assertThrows(Circles2DException.class, () -> step(world), fault + " and so do all after it");
                }
            }
        } catch (Circles2DException e) {
            // the world was not built
        }
        boolean created = !faulty.calls().equals(List.of("createContext"));
        assertEquals(created, !log.take().isEmpty(), fault + " and so do all after it: failed releases are told");
        assertNothingLeft(fault + " and so do all after it");
    }

    private void assertNothingLeft(String fault) {
        assertEquals(List.of(), faulty.misuses(), fault);
        assertEquals(List.of(), faulty.live(), fault);
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, -2, -5, -6, -30, -1001})
    void faultsWhileListingOnlyShrinkTheList(int status) {
        faulty.behave();
        int all = OpenClDevices.list(faulty.api()).size();
        List<String> calls = faulty.calls();
        assertTrue(calls.containsAll(Set.of("getPlatformIDs", "getPlatformInfo", "getDeviceIDs", "getDeviceInfo")));
        for (int k = 0; k < calls.size(); k++) {
            faulty.fail(k, status, false);
            int left = OpenClDevices.list(faulty.api()).size();
            assertTrue(left < all, calls.get(k) + " " + k + " gives " + status + ": " + left + " of " + all);
        }
    }

    @Test
    void aDeviceWhoseSelfCheckFailsIsNotDeterministic() {
        faulty.behave();
        assertTrue(device.deterministic());
        List<String> calls = faulty.calls();
        for (int k = 0; k < calls.size(); k++) {
            faulty.behave();
            ComputeDevice fresh =
                    Internals.computeDevice(OpenClDevices.list(faulty.api()).get(0));
            faulty.fail(k, -5, false);
            // what is only released was computed, and right
            boolean computed = k >= calls.indexOf("finish");
            assertEquals(computed, fresh.deterministic(), calls.get(k));
            assertFalse(log.take().isEmpty(), calls.get(k));
            assertNothingLeft(calls.get(k));
        }
    }

    @Test
    void aFailedWorldNamesItsFirstFailureAndTheNextOneIsUntouched() {
        List<Object> expected = healthy(World.SLICES_OF_A_TRIANGLE);
        faulty.behave();
        try (Circles2D world = builder(World.SLICES_OF_A_TRIANGLE).build()) {
            addPile(world);
            world.step();
            faulty.fail(0, -36, true);
            OpenClException first = assertThrows(OpenClException.class, world::step);
            assertEquals(-36, first.status());
            assertEquals("clEnqueueNDRangeKernel(c2d_update)", first.call());
            faulty.behave();
            List<Executable> later = List.of(
                    world::step,
                    world::snapshot,
                    world::stateHash,
                    world::stats,
                    world::circleCount,
                    () -> world.addCircle(0.5f, 0.5f, 0.1f, 1),
                    () -> world.setVelocity(0, 1, 1));
            for (Executable use : later) {
                assertSame(first, assertThrows(Circles2DException.class, use).getCause());
            }
            assertFalse(faulty.calls().contains("enqueueNDRangeKernel"));
        }
        assertNothingLeft("after a lost device");
        assertEquals(expected, healthy(World.SLICES_OF_A_TRIANGLE));
    }

    @Test
    void aFailureInTheBackgroundIsThrownByTheNextCallAndThenNamed() {
        List<Function<Circles2D, Object>> calls = List.of(
                Circles2D::snapshot,
                Circles2D::stateHash,
                FaultTest::stats,
                Circles2D::deviceMemory,
                world -> world.addCircle(0.5f, 0.5f, 0.1f, 1),
                FaultTest::setVelocity);
        for (Function<Circles2D, Object> call : calls) {
            faulty.behave();
            try (Circles2D world = builder(World.IN_BACKGROUND).build()) {
                addPile(world);
                world.step();
                float x = world.snapshot().x(3);
                Snapshot before = world.snapshot();
                faulty.fail(0, -36, true);
                world.step(5);
                OpenClException first = assertThrows(OpenClException.class, () -> call.apply(world));
                assertEquals(-36, first.status());
                assertEquals(1, faulty.calls().size(), "no step after it");
                assertSame(
                        first,
                        assertThrows(Circles2DException.class, world::step).getCause());
                assertSame(
                        first,
                        assertThrows(Circles2DException.class, () -> call.apply(world))
                                .getCause());
                assertEquals(x, before.x(3));
                faulty.behave();
            }
            assertNothingLeft("after a failure in the background");
            assertEquals(List.of(), log.take());
        }
    }

    @Test
    void velocitiesThatDoNotArriveInTheBackgroundEndTheWorld() {
        faulty.behave();
        try (Circles2D world = builder(World.IN_BACKGROUND).build()) {
            addPile(world);
            world.step();
            world.snapshot();
            world.setVelocity(3, 1, 2);
            faulty.fail(0, -36, false);
            world.step();
            OpenClException first = assertThrows(OpenClException.class, world::snapshot);
            assertEquals("clEnqueueWriteBuffer", first.call());
            assertSame(
                    first, assertThrows(Circles2DException.class, world::step).getCause());
            faulty.behave();
        }
        assertNothingLeft("after velocities that did not arrive");
        assertEquals(List.of(), log.take());
    }

    private static Object setVelocity(Circles2D world) {
        world.setVelocity(0, 1, 1);
        return "set";
    }

    private void beginAStepThatFails(Circles2D world) throws InterruptedException {
        addPile(world);
        world.step();
        world.snapshot();
        faulty.fail(0, -36, false);
        world.step();
        while (faulty.calls().isEmpty()) {
            Thread.sleep(1);
        }
    }

    @Test
    void stepsThrowWhatAStepBeforeThemInTheBackgroundHasThrown() throws InterruptedException {
        faulty.behave();
        try (Circles2D world = builder(World.IN_BACKGROUND).build()) {
            beginAStepThatFails(world);
            assertThrows(OpenClException.class, () -> {
                for (int i = 0; i < 10_000; i++) {
                    world.step();
                    Thread.sleep(1);
                }
            });
        }
        assertNothingLeft("after a failure in the background");
    }

    @Test
    void aFailureThatNoCallHasThrownIsLoggedAtTheEnd() throws InterruptedException {
        faulty.behave();
        try (Circles2D world = builder(World.IN_BACKGROUND).build()) {
            beginAStepThatFails(world);
        }
        assertNothingLeft("after a failure in the background");
        assertEquals(List.of("a step failed, and the world was closed"), log.take());
    }

    /** Circles that touch and rest, whose list is kept from the second step on; then a change. */
    private Circles2D changeAfterAListThatIsKept(Circles2D world, Consumer<Circles2D> change) {
        for (int i = 0; i < 20; i++) {
            world.addCircle(0.1f + 0.04f * i, 0.5f, 0.02f, 1);
        }
        world.step(2);
        world.snapshot();
        int listed = faulty.launches("c2d_find_count");
        world.step(3);
        world.snapshot();
        assertEquals(listed, faulty.launches("c2d_find_count"), "is kept");
        change.accept(world);
        return world;
    }

    @Test
    void anUploadThatFailsIsDoneAgainAndNothingOfTheListBeforeIsKept() {
        callsOfAStepFail(Integer.MAX_VALUE, 4, world -> world.addCircle(0.3f, 0.51f, 0.02f, 1));
    }

    @Test
    void velocitiesThatDoNotArriveAreSentAgain() {
        // one writes them, one takes them over; what the step does then is the same
        callsOfAStepFail(20, 2, world -> world.setVelocity(3, 1, 2));
    }

    /** Each of the first {@code most} calls fails; of some of the first the world does not. */
    private void callsOfAStepFail(int most, int harmless, Consumer<Circles2D> change) {
        Circles2D.Builder resting =
                Internals.builder(0, 0, 0).device(device).substeps(2).gravity(0, 0);
        faulty.behave();
        long expected;
        List<String> calls;
        try (Circles2D world = changeAfterAListThatIsKept(resting.build(), change)) {
            int listed = faulty.launches("c2d_find_count");
            faulty.behave();
            world.step();
            calls = faulty.calls();
            assertTrue(faulty.launches("c2d_find_count") > listed, "contacts are listed anew");
            expected = world.stateHash();
        }
        int again = 0;
        for (int k = 0; k < Math.min(most, calls.size()); k++) {
            faulty.behave();
            try (Circles2D world = changeAfterAListThatIsKept(resting.build(), change)) {
                faulty.fail(k, STATUSES.get(k % STATUSES.size()), false);
                Circles2DException first = failure(world);
                Circles2DException second = first == null ? null : failure(world);
                String fault = calls.get(k) + " " + k;
                if (second != null) {
                    assertSame(first, second.getCause(), fault + ": the world has failed");
                    continue;
                }
                again += first == null ? 0 : 1;
                assertEquals(expected, world.stateHash(), fault);
            }
        }
        assertTrue(again >= harmless, again + " faults are before a step begins, and it is done again");
        log.take();
        assertNothingLeft("after uploads that failed");
    }

    /** What a step throws, or null. */
    private static Circles2DException failure(Circles2D world) {
        try {
            world.step();
            return null;
        } catch (Circles2DException e) {
            return e;
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"createBuffer", "enqueueMapBuffer"})
    void withoutPinnedMemoryCirclesComeBackAllTheSame(String call) {
        List<Object> expected = healthy(World.SMALL_STEPS);
        List<String> calls = faulty.calls();
        int map = calls.indexOf("enqueueMapBuffer");
        assertEquals("createBuffer", calls.get(map - 1));
        faulty.fail(call.equals("createBuffer") ? map - 1 : map, -4, false);
        List<Object> results = new ArrayList<>();
        try (Circles2D world = builder(World.SMALL_STEPS).build()) {
            USE.forEach(use -> results.add(use.apply(world)));
        }
        assertEquals(expected, results);
        assertTrue(log.take().get(0).contains("no pinned memory"));
        assertNothingLeft(call);
    }
}
