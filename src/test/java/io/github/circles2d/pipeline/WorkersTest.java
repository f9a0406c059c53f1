package io.github.circles2d.pipeline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Each item is done once, in order of the parts, whoever helps and whatever fails. */
@Timeout(60)
class WorkersTest {
    private static final int ITEMS = 40 * Tuning.HOST_ITEMS + 7;

    @Test
    void everyItemIsDoneOnceInEachOfManyRuns() {
        Workers workers = new Workers(Tuning.HOST_ITEMS, Integer.MAX_VALUE);
        int[] done = new int[ITEMS];
        Workers.Work work = (part, from, end) -> {
            assertTrue(part < workers.most());
            for (int i = from; i < end; i++) {
                done[i]++;
            }
        };
        int[] expected = new int[ITEMS];
        for (int run = 1; run <= 2000; run++) {
            // few and many, evenly and not; now and then helpers have gone to sleep
            int items = run * 7919 % ITEMS;
            if (run % 2 == 0) {
                workers.run(items, work);
            } else {
                workers.runUneven(items, work);
            }
            if (run % 200 == 0) {
                LockSupport.parkNanos(2 * Tuning.HOST_IDLE);
            }
            for (int i = 0; i < items; i++) {
                expected[i]++;
            }
            assertArrayEquals(expected, done, "run " + run);
        }
    }

    @Test
    void partsAreInTheOrderOfTheItems() {
        Workers workers = new Workers(Tuning.HOST_ITEMS, Integer.MAX_VALUE);
        int[] begins = new int[workers.most()];
        int[] ends = new int[workers.most()];
        workers.runUneven(ITEMS, (part, from, end) -> {
            begins[part] = from;
            ends[part] = end;
        });
        int reached = 0;
        for (int part = 0; part < begins.length && ends[part] > 0; part++) {
            assertTrue(begins[part] == reached && ends[part] > reached, () -> Arrays.toString(begins));
            reached = ends[part];
        }
        assertTrue(reached == ITEMS, () -> Arrays.toString(ends));
    }

    @Test
    void noMoreThreadsAtOnceThanAskedFor() {
        for (int threads = 1; threads <= 3; threads++) {
            Workers workers = new Workers(1, threads);
            AtomicInteger working = new AtomicInteger();
            AtomicInteger most = new AtomicInteger();
            for (int run = 0; run < 200; run++) {
                workers.runUneven(ITEMS, (part, from, end) -> {
                    most.accumulateAndGet(working.incrementAndGet(), Math::max);
                    LockSupport.parkNanos(10_000);
                    working.decrementAndGet();
                });
            }
            assertTrue(most.get() <= threads, most + " of " + threads);
            assertTrue(threads == 1 || most.get() > 1, "never helped");
        }
    }

    @Test
    void whatAPartThrowsReachesTheCallerAndTheNextRunIsWhole() {
        Workers workers = new Workers(Tuning.HOST_ITEMS, Integer.MAX_VALUE);
        IllegalStateException failure = new IllegalStateException("in the second part");
        for (int turn = 0; turn < 50; turn++) {
            assertSame(
                    failure,
                    assertThrows(
                            IllegalStateException.class,
                            () -> workers.runUneven(ITEMS, (part, from, end) -> {
                                if (part >= 1) {
                                    throw part == 1 ? failure : new IllegalStateException("in a later one");
                                }
                            })));
            int[] done = new int[ITEMS];
            workers.run(ITEMS, (part, from, end) -> Arrays.fill(done, from, end, 1));
            assertTrue(Arrays.stream(done).allMatch(times -> times == 1));
        }
    }

    @Test
    void worksWhileThePoolIsBusyAndBesideOthers() throws Exception {
        int threads = ForkJoinPool.getCommonPoolParallelism();
        ForkJoinTask<?>[] busy = new ForkJoinTask<?>[threads];
        AtomicBoolean free = new AtomicBoolean();
        for (int k = 0; k < threads; k++) {
            busy[k] = ForkJoinPool.commonPool().submit(() -> {
                while (!free.get()) {
                    Thread.onSpinWait();
                }
            });
        }
        try {
            FutureTask<?> beside = new FutureTask<>(this::everyItemIsDoneOnceInEachOfManyRuns, null);
            new Thread(beside).start();
            everyItemIsDoneOnceInEachOfManyRuns();
            beside.get(30, TimeUnit.SECONDS);
        } finally {
            free.set(true);
        }
        for (ForkJoinTask<?> task : busy) {
            task.get(10, TimeUnit.SECONDS);
        }
    }
}
