package io.github.circles2d.host;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.pipeline.Tuning;
import java.util.Arrays;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Each item is done once, in order of the parts, whoever helps and whatever fails. */
@Timeout(60)
class WorkersTest {
    private static final int ITEMS = 40 * Tuning.HOST_ITEMS + 7;

    @Test
    void everyItemIsDoneOnceInEachOfManyRuns() {
        Workers workers = new Workers();
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
        Workers workers = new Workers();
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
    void whatAPartThrowsReachesTheCallerAndTheNextRunIsWhole() {
        Workers workers = new Workers();
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
