package io.github.circles2d.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;

class MeanwhileTest {
    @Test
    void aThreadOfItsOwnMakesIt() {
        CountDownLatch asked = new CountDownLatch(1);
        Meanwhile<Thread> made = new Meanwhile<>(true, () -> {
            await(asked);
            return Thread.currentThread();
        });
        // whoever started it has gone on
        asked.countDown();
        assertNotSame(Thread.currentThread(), made.get());
        assertTrue(made.get().isDaemon());
    }

    @Test
    void withoutOneItIsMadeWhereItIsAskedFor() {
        int[] times = {0};
        Meanwhile<Thread> made = new Meanwhile<>(false, () -> {
            times[0]++;
            return Thread.currentThread();
        });
        assertEquals(0, times[0]);
        assertSame(Thread.currentThread(), made.get());
        assertSame(Thread.currentThread(), made.get());
        assertEquals(1, times[0]);
    }

    @Test
    void whatMakingItThrowsComesThrough() {
        for (boolean start : List.of(false, true)) {
            RuntimeException exception = new IllegalStateException("on purpose");
            assertSame(exception, assertThrows(RuntimeException.class, throwing(start, exception)::get));
            Error error = new OutOfMemoryError("on purpose");
            assertSame(error, assertThrows(Error.class, throwing(start, error)::get));
        }
    }

    @Test
    void anInterruptWaits() {
        Thread caller = Thread.currentThread();
        caller.interrupt();
        Meanwhile<Integer> made = new Meanwhile<>(true, () -> {
            // who waits has seen it once that is taken back
            while (caller.isInterrupted()) {
                Thread.onSpinWait();
            }
            return 5;
        });
        assertEquals(5, made.get());
        assertTrue(Thread.interrupted());
    }

    private static Meanwhile<Integer> throwing(boolean start, Throwable thrown) {
        return new Meanwhile<>(start, () -> {
            if (thrown instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) thrown;
        });
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }
}
