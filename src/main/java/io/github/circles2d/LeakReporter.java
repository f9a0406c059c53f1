package io.github.circles2d;

import java.lang.ref.Cleaner;

/** Says when a world became garbage without being closed. It only says so: device memory is never freed by the collector. */
final class LeakReporter implements Runnable {
    private static final System.Logger LOG = System.getLogger(Circles2D.class.getName());
    private static final Cleaner CLEANER = Cleaner.create();

    private final String device;
    private volatile boolean closed;

    private LeakReporter(String device) {
        this.device = device;
    }

    static LeakReporter watch(Circles2D world, String device) {
        LeakReporter reporter = new LeakReporter(device);
        CLEANER.register(world, reporter);
        return reporter;
    }

    void closed() {
        closed = true;
    }

    @Override
    public void run() {
        if (!closed) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    "a world on {0} was never closed; what it holds stays allocated",
                    device);
        }
    }
}
