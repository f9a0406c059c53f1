package io.github.circles2d.pipeline;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Supplier;

/**
 * Something that a thread of its own makes while the one that wants it does something else. That thread is none of Java's common pool:
 * whoever keeps the pool busy would keep a world from being built.
 *
 * @param <T> what is made
 */
public final class Meanwhile<T> {
    private final CompletableFuture<T> made = new CompletableFuture<>();
    private final Supplier<T> maker;
    private final boolean started;

    /**
     * Starts to make it.
     *
     * @param start false where that is not worth a thread: then it is made where it is asked for
     */
    public Meanwhile(boolean start, Supplier<T> maker) {
        this.maker = maker;
        started = start;
        if (start) {
            made.completeAsync(maker, task -> {
                Thread thread = new Thread(task, "circles2d-build");
                thread.setDaemon(true);
                thread.start();
            });
        }
    }

    /** What has been made. Waits for it, interrupted or not, and throws what making it has thrown. */
    public T get() {
        if (!started) {
            // does nothing where it has been made
            made.completeAsync(maker, Runnable::run);
        }
        try {
            return made.join();
        } catch (CompletionException e) {
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) e.getCause();
        }
    }
}
