package io.github.circles2d;

import java.lang.ref.Cleaner;

/** Says when a world became garbage without being closed. It only says so: device memory is never freed by the collector. */
final class LeakReporter implements Runnable {
    private static final System.Logger LOG = System.getLogger(Circles2D.class.getName());
    private static final Cleaner CLEANER = Cleaner.create();

    private final String device;
    private final Runnable abandon;
    private volatile boolean closed;

    private LeakReporter(String device, Runnable abandon) {
        this.device = device;
        this.abandon = abandon;
    }

    /** @param abandon what to do then besides; must not hold the world */
    static LeakReporter watch(Circles2D world, String device, Runnable abandon) {
        LeakReporter reporter = new LeakReporter(device, abandon);
        CLEANER.register(world, reporter);
        return reporter;
    }

    void closed() {
        closed = true;
    }

    @Override
    public void run() {
        if (!closed) {
            abandon.run();
            LOG.log(
                    System.Logger.Level.WARNING,
                    "a world on {0} was never closed; what it holds stays allocated",
                    device);
        }
    }
}
