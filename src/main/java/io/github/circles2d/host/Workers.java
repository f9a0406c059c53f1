package io.github.circles2d.host;

import io.github.circles2d.pipeline.Tuning;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;

/**
 * Shares the work of a stage among the threads of Java's common pool, in parts that touch nothing in common: who does which
 * leaves no trace. Allocates nothing after its first use.
 */
final class Workers {
    /** Does items {@code from .. end - 1}, as part number {@code part}. */
    interface Work {
        void run(int part, int from, int end);
    }

    /** One part; used again for every run. */
    @SuppressWarnings("serial")
    private static final class Task extends ForkJoinTask<Void> {
        private final int part;
        private Work work;
        private int from;
        private int end;

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
            work.run(part, from, end);
            return true;
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
            Task task = tasks[part];
            task.work = work;
            task.from = (int) ((long) items * part / parts);
            task.end = (int) ((long) items * (part + 1) / parts);
            task.reinitialize();
            ForkJoinPool.commonPool().execute(task);
        }
        try {
            work.run(0, 0, items / parts);
        } finally {
            for (int part = parts - 1; part > 0; part--) {
                tasks[part].quietlyJoin();
            }
        }
        for (int part = 1; part < parts; part++) {
            // throws what the part threw
            tasks[part].join();
        }
    }
}
