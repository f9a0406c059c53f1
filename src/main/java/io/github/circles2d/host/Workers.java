package io.github.circles2d.host;

import io.github.circles2d.pipeline.Tuning;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Shares the work of a stage among the threads of Java's common pool, in parts that touch nothing in common: who does which
 * leaves no trace. Allocates nothing after its first use.
 */
final class Workers {
    /** Does items {@code from .. end - 1}, as part number {@code part}. */
    interface Work {
        void run(int part, int from, int end);
    }

    /**
     * One part; used again for every run, so it never completes as the pool understands it: a task that completes and starts
     * again loses the one who waits for it. Whoever opens it first does it, a thread of the pool or the one that waits.
     */
    @SuppressWarnings("serial")
    private static final class Task extends ForkJoinTask<Void> {
        private static final int OPEN = 0;
        private static final int TAKEN = 1;
        private static final int DONE = 2;

        private final AtomicInteger progress = new AtomicInteger(DONE);
        private final AtomicBoolean queued = new AtomicBoolean();
        private final int part;
        private Work work;
        private int from;
        private int end;
        private Throwable failure;

        Task(int part) {
            this.part = part;
        }

        @Override
        public Void getRawResult() {
            return null;
        }

        @Override
        protected void setRawResult(Void value) {}

        @Override
        protected boolean exec() {
            // who has just worked is soon wanted again, and waking takes longer than most parts
            long idleFrom = System.nanoTime();
            while (System.nanoTime() - idleFrom < Tuning.HOST_IDLE) {
                if (attempt()) {
                    idleFrom = System.nanoTime();
                }
                Thread.onSpinWait();
            }
            queued.set(false);
            attempt();
            return false;
        }

        void start(Work newWork, int newFrom, int newEnd) {
            work = newWork;
            from = newFrom;
            end = newEnd;
            failure = null;
            progress.set(OPEN);
            if (queued.compareAndSet(false, true)) {
                ForkJoinPool.commonPool().execute(this);
            }
        }

        boolean attempt() {
            if (progress.get() != OPEN || !progress.compareAndSet(OPEN, TAKEN)) {
                return false;
            }
            try {
                work.run(part, from, end);
            } catch (RuntimeException | Error e) {
                failure = e;
            } finally {
                progress.set(DONE);
            }
            return true;
        }

        void await() {
            for (int turns = 0; progress.get() != DONE; turns++) {
                if (turns < Tuning.HOST_SPINS) {
                    Thread.onSpinWait();
                } else {
                    Thread.yield();
                }
            }
        }
    }

    private final Task[] tasks = new Task[Math.max(1, ForkJoinPool.getCommonPoolParallelism() + 1)];

    Workers() {
        for (int part = 0; part < tasks.length; part++) {
            tasks[part] = new Task(part);
        }
    }

    /** Most parts of a run. */
    int most() {
        return tasks.length;
    }

    /** Does {@code items} items, few of them in this thread alone; returns when all are done. */
    void run(int items, Work work) {
        int parts = Math.min(tasks.length, items / Tuning.HOST_ITEMS);
        if (parts <= 1) {
            work.run(0, 0, items);
            return;
        }
        for (int part = 1; part < parts; part++) {
            tasks[part].start(work, (int) ((long) items * part / parts), (int) ((long) items * (part + 1) / parts));
        }
        try {
            work.run(0, 0, items / parts);
        } finally {
            for (int part = parts - 1; part > 0; part--) {
                tasks[part].attempt();
            }
            for (int part = 1; part < parts; part++) {
                tasks[part].await();
            }
        }
        for (int part = 1; part < parts; part++) {
            Throwable failure = tasks[part].failure;
            if (failure instanceof Error error) {
                throw error;
            }
            if (failure != null) {
                throw (RuntimeException) failure;
            }
        }
    }
}
