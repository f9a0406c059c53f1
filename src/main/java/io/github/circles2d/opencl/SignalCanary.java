package io.github.circles2d.opencl;

import java.util.concurrent.atomic.AtomicBoolean;

/**
 * What drivers do to the signals that the JVM lives by.
 *
 * <p>PoCL before 4.0 takes over the signal for a division by zero: in interpreted code {@code 1 / 0} is then 1. Nothing in
 * this library divides by zero; the application may rely on the exception, so it is told.
 *
 * <p>The LLVM inside of PoCL, when it starts and when it has compiled a kernel, waits for the signal for a bad address, which the JVM uses to
 * stop its threads; the first one puts the JVM's handlers back. Between the two the signal has no handler at all: when the
 * JVM stops two threads at once, the second signal ends the process without a word. So {@link #handBack} makes the first
 * one itself, at a quiet moment.
 */
final class SignalCanary {
    private static final System.Logger LOG = System.getLogger("io.github.circles2d");
    private static final AtomicBoolean TOLD = new AtomicBoolean();

    private static SignalCanary nobody;

    private int nothing;

    private SignalCanary() {}

    /** Makes the JVM read from a bad address, after kernels may have been compiled. */
    static void handBack() {
        try {
            nobody.nothing++;
        } catch (NullPointerException e) {
            LOG.log(System.Logger.Level.TRACE, "the JVM has its handler for bad addresses");
        }
    }

    static void check() {
        if (!TOLD.get() && !throwsOnZero(0) && TOLD.compareAndSet(false, true)) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    "an OpenCL driver (PoCL before 4.0 does it) has taken over the JVM's signal handlers: an integer"
                            + " division by zero in Java no longer throws, and in rare cases the process may end. Start Java with"
                            + " LD_PRELOAD=$JAVA_HOME/lib/libjsig.so to keep both working.");
        }
    }

    private static boolean throwsOnZero(int zero) {
        try {
            return 1 / zero == Integer.MIN_VALUE;
        } catch (ArithmeticException e) {
            return true;
        }
    }
}
