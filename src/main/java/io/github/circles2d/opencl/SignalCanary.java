package io.github.circles2d.opencl;

import java.util.concurrent.atomic.AtomicBoolean;

/**
 * PoCL before 4.0 takes over the signal the JVM needs to notice a division by zero: in interpreted code {@code 1 / 0} is
 * then 1. Nothing in this library divides by zero; the application may rely on the exception, so it is told.
 */
final class SignalCanary {
    private static final System.Logger LOG = System.getLogger("io.github.circles2d");
    private static final AtomicBoolean TOLD = new AtomicBoolean();

    private SignalCanary() {}

    static void check() {
        if (!TOLD.get() && !throwsOnZero(0) && TOLD.compareAndSet(false, true)) {
            LOG.log(
                    System.Logger.Level.WARNING,
                    "an OpenCL driver (PoCL before 4.0 does it) has taken over the JVM's signal handlers: an integer"
                            + " division by zero in Java no longer throws. Start Java with"
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
