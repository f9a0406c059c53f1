package io.github.circles2d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.demo.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

@Timeout(120)
class ConcurrencyTest {
    private static final int THREADS = 4;

    /** Runs a task in several threads that start together. */
    private static <T> List<T> together(Callable<T> task) throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(THREADS);
        CyclicBarrier start = new CyclicBarrier(THREADS);
        try {
            List<Future<T>> futures = new ArrayList<>();
            for (int t = 0; t < THREADS; t++) {
                futures.add(threads.submit(() -> {
                    start.await(30, TimeUnit.SECONDS);
                    return task.call();
                }));
            }
            List<T> results = new ArrayList<>();
            for (Future<T> future : futures) {
                results.add(future.get(90, TimeUnit.SECONDS));
            }
            return results;
        } finally {
            threads.shutdownNow();
        }
    }

    private static long run(ComputeDevice device, IndexStrategy strategy) {
        Circles2D.Builder builder = Circles2D.builder().device(device).indexStrategy(strategy);
        try (Circles2D world = Scene.THESIS.build(builder, 200)) {
            for (int step = 0; step < 50; step++) {
                world.step();
            }
            return world.stateHash();
        }
    }

    static Stream<Arguments> worlds() {
        return TestDevices.both().flatMap(device -> Stream.of(Arguments.of(device, false), Arguments.of(device, true)));
    }

    @ParameterizedTest
    @MethodSource("io.github.circles2d.TestDevices#both")
    void worldsInSeveralThreads(Supplier<ComputeDevice> device) throws Exception {
        long serial = run(ComputeDevice.host(), IndexStrategy.folded());
        ComputeDevice on = device.get();
        for (IndexStrategy strategy : List.of(IndexStrategy.folded(), IndexStrategy.pairTable())) {
            for (long hash : together(() -> run(on, strategy))) {
                assertEquals(serial, hash);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("worlds")
    void oneWorldInSeveralThreads(Supplier<ComputeDevice> device, boolean background) throws Exception {
        int each = 25;
        Circles2D.Builder builder = Circles2D.builder().device(device.get()).background(background);
        try (Circles2D world = Scene.THESIS.build(builder, 100)) {
            together(() -> {
                for (int k = 0; k < each; k++) {
                    world.step();
                    world.addCircle(0.5f, 0.5f, 0.01f, 1);
                    world.setVelocity(k, 0.1f, 0.1f);
                    world.stateHash();
                    assertEquals(0, world.stats().outside());
                    assertTrue(world.snapshot().count() >= 100);
                }
                return null;
            });
            assertEquals(100 + THREADS * each, world.circleCount());
            assertEquals((long) THREADS * each, world.stats().steps());
        }
    }

    /** Steps alone, so that their number is all that counts. */
    @ParameterizedTest
    @MethodSource("worlds")
    void stepsFromSeveralThreadsAddUp(Supplier<ComputeDevice> device, boolean background) throws Exception {
        int each = 20;
        long serial;
        try (Circles2D world = Scene.THESIS.build(Circles2D.builder().device(ComputeDevice.host()), 200)) {
            world.step(THREADS * each);
            serial = world.stateHash();
        }
        try (Circles2D world =
                Scene.THESIS.build(Circles2D.builder().device(device.get()).background(background), 200)) {
            together(() -> {
                for (int k = 0; k < each; k++) {
                    world.step();
                }
                return null;
            });
            assertEquals(serial, world.stateHash());
        }
    }

    /** One thread closes the world that others use: they get an IllegalStateException, the JVM lives. */
    @ParameterizedTest
    @MethodSource("worlds")
    void closedWhileOthersStep(Supplier<ComputeDevice> device, boolean background) throws Exception {
        Circles2D world =
                Scene.THESIS.build(Circles2D.builder().device(device.get()).background(background), 200);
        List<Boolean> ended = together(() -> {
            try {
                for (int k = 0; k < 100_000; k++) {
                    world.step();
                    if (k == 10) {
                        world.close();
                    }
                }
                return false;
            } catch (IllegalStateException e) {
                return true;
            }
        });
        assertEquals(List.of(true, true, true, true), ended);
    }
}
