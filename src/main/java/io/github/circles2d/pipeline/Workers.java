package io.github.circles2d.pipeline;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Shares work among threads of Java's common pool, in parts that touch nothing in common: who does which
 * leaves no trace. Allocates nothing after its first use.
 */
public final class Workers {
    /** Does items {@code from .. end - 1}, as part number {@code part}. */
    public interface Work {
        void run(int part, int from, int end);
    }

    /**
     * What a thread of the pool helps with; used again for every run, so it never completes as the pool understands it: a task
     * that completes and starts again loses the one who waits for it.
     */
    @SuppressWarnings("serial")
    private final class Helper extends ForkJoinTask<Void> {
        private final AtomicBoolean queued = new AtomicBoolean();

        @Override
        public Void getRawResult() {
            return null;
        }

        @Override
        protected void setRawResult(Void value) {}

        @Override
        protected boolean exec() {
            // who has just worked is soon wanted again, and waking takes longer than most parts; but the pool is for
            // others, too
            long begun = System.nanoTime();
            long idleFrom = begun;
            for (long now = begun;
                    now - idleFrom < Tuning.HOST_IDLE && now - begun < Tuning.HOST_STAY;
                    now = System.nanoTime()) {
                idleFrom = help() ? System.nanoTime() : idleFrom;
                Thread.onSpinWait();
            }
            queued.set(false);
            // a run that began just before found it queued
            help();
            return false;
        }

        void wake() {
            if (queued.compareAndSet(false, true)) {
                try {
                    ForkJoinPool.commonPool().execute(this);
                } catch (RejectedExecutionException e) {
                    // then who calls does it all
                    queued.set(false);
                }
            }
        }
    }

    private final Helper[] helpers;
    private final Throwable[] failures;

    /** Of a run: its number, the parts it has, and how many of them have been taken, in one so that they change at once. */
    private final AtomicLong taken = new AtomicLong();

    private final AtomicInteger undone = new AtomicInteger();
    private final int fewest;
    private Work work;
    private int items;

    /**
     * For work that is shared in parts of some items.
     *
     * @param fewest least items of a part
     * @param threads most that work, the one that calls included; the pool may have fewer
     */
    public Workers(int fewest, int threads) {
        this.fewest = fewest;
        helpers = new Helper[Math.min(ForkJoinPool.getCommonPoolParallelism(), threads - 1)];
        failures = new Throwable[Math.min(0xFFFF, (1 + helpers.length) * Tuning.HOST_PARTS)];
        for (int k = 0; k < helpers.length; k++) {
            helpers[k] = new Helper();
        }
    }

    /** Most parts of a run. */
    public int most() {
        return failures.length;
    }

    /**
     * Does {@code items} items that take as long as each other, few of them in this thread alone; returns when all are done. As many
     * parts as threads: most then find in their cache what they did before.
     */
    public void run(int items, Work work) {
        run(items, work, 1 + helpers.length);
    }

    /** The same of items some of which take much longer than others. */
    public void runUneven(int items, Work work) {
        run(items, work, most());
    }

    private void run(int newItems, Work newWork, int mostParts) {
        int parts = Math.min(mostParts, newItems / fewest);
        if (parts <= 1) {
            newWork.run(0, 0, newItems);
            return;
        }
        work = newWork;
        items = newItems;
        undone.set(parts);
        taken.set((taken.get() >>> 32) + 1 << 32 | (long) parts << 16);
        try {
            for (int k = 0; k < Math.min(helpers.length, parts - 1); k++) {
                helpers[k].wake();
            }
        } finally {
            help();
            await();
        }
        rethrow(parts);
    }

    private void await() {
        for (int turns = 0; undone.get() > 0; turns++) {
            if (turns < Tuning.HOST_SPINS) {
                Thread.onSpinWait();
            } else {
                Thread.yield();
            }
        }
        // a helper that the pool still has should not keep a world that is gone
        work = null;
    }

    /** Takes parts until there are none; whether there were any. */
    private boolean help() {
        boolean helped = false;
        long now = taken.get();
        while ((now & 0xFFFF) < (now >>> 16 & 0xFFFF)) {
            if (taken.compareAndSet(now, now + 1)) {
                part((int) (now & 0xFFFF), (int) (now >>> 16 & 0xFFFF));
                helped = true;
            }
            now = taken.get();
        }
        return helped;
    }

    private void part(int part, int parts) {
        try {
            work.run(part, (int) ((long) items * part / parts), (int) ((long) items * (part + 1) / parts));
        } catch (RuntimeException | Error e) {
            failures[part] = e;
        } finally {
            undone.decrementAndGet();
        }
    }

    private void rethrow(int parts) {
        Throwable first = null;
        for (int part = parts - 1; part >= 0; part--) {
            first = failures[part] == null ? first : failures[part];
            failures[part] = null;
        }
        if (first instanceof Error error) {
            throw error;
        }
        if (first != null) {
            throw (RuntimeException) first;
        }
    }
}
