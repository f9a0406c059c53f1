package io.github.circles2d.pipeline;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** Reads the kernel files that travel in the jar. */
public final class KernelSources {
    private static final String FOLDER = "/io/github/circles2d/kernels/";

    private KernelSources() {}

    /** The text of a file of {@code kernels/}. */
    public static String read(String file) {
        try (InputStream in = KernelSources.class.getResourceAsStream(FOLDER + file)) {
            if (in == null) {
                throw new IllegalStateException("kernels/" + file + " is missing from the class path");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
