package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.CircleBuffers;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.Workers;
import java.nio.FloatBuffer;

/**
 * Carries circles between the staging memory and the buffers of the host, many of them by several threads: one alone takes longer for a
 * million than a GPU takes to send them. But the first few times one does: a young JVM interprets, and threads that do the same then wait for each other
 * where it counts what they do. Allocates nothing after that.
 */
final class StagedCircles {
    /** Floats of a circle: the device has (x, y, radius, mass) where the host has transforms. */
    static final int TRANSFORM = 4;

    /** The same of (vx, vy). */
    static final int VELOCITY = 2;

    private final Staging staging;
    private final Workers workers = new Workers(Tuning.COPY_CIRCLES, Tuning.COPY_THREADS);
    private final Workers.Work copyToHost = this::copyToHost;
    private final Workers.Work copyToStaging = this::copyToStaging;

    /** How often one thread has carried alone. */
    private int alone;

    // of what is carried now
    private FloatBuffer host;
    private FloatBuffer masses;
    private int floats;
    private int staged;
    private int first;

    StagedCircles(Staging staging) {
        this.staging = staging;
    }

    /**
     * Copies what the staging memory has from float {@code from} on.
     *
     * @param width how many floats each circle has; those that are transforms become so
     * @param start the first circle in {@code to}
     */
    void toHost(int from, FloatBuffer to, int width, int start, int circles) {
        carry(copyToHost, from, to, null, width, start, circles);
    }

    /**
     * Copies to the start of the staging memory.
     *
     * @param theirMasses what comes in the place of angles; null of what has none
     */
    void toStaging(FloatBuffer from, FloatBuffer theirMasses, int width, int start, int circles) {
        carry(copyToStaging, 0, from, theirMasses, width, start, circles);
    }

    private void carry(
            Workers.Work work, int at, FloatBuffer with, FloatBuffer theirMasses, int width, int start, int circles) {
        host = with;
        masses = theirMasses;
        floats = width;
        staged = at;
        first = start;
        if (alone < Tuning.COPIES_ALONE) {
            alone++;
            work.run(0, 0, circles);
        } else {
            workers.run(circles, work);
        }
        // buffers that a growing world has replaced should not be kept
        host = null;
        masses = null;
    }

    private void copyToHost(int part, int from, int end) {
        host.put(floats * (first + from), staging.floats(), staged + floats * from, floats * (end - from));
        if (floats == TRANSFORM) {
            CircleBuffers.setAngles(host, first + from, first + end);
        }
    }

    private void copyToStaging(int part, int from, int end) {
        FloatBuffer to = staging.floats();
        to.put(floats * from, host, floats * (first + from), floats * (end - from));
        if (masses != null) {
            for (int i = from; i < end; i++) {
                to.put(TRANSFORM * i + 3, masses.get(first + i));
            }
        }
    }
}
