package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Substeps;
import org.jocl.Pointer;
import org.jocl.Sizeof;

/**
 * An argument of kernels: the struct {@code c2d_world} of {@code kernels/small.cl}. Its numbers change with the substeps; a kernel that
 * has it gets it anew then, when it is launched next.
 */
final class WorldArgument {
    private final Heap heap;
    /** Where the parts of the heap begin and so on, then the numbers, as bits. */
    private final int[] words;

    private final Pointer toWords;

    /** @param places what comes first in the struct, all but the numbers */
    WorldArgument(Heap heap, int[] places) {
        this.heap = heap;
        words = new int[places.length + Substeps.NUMBERS];
        System.arraycopy(places, 0, words, 0, places.length);
        toWords = Pointer.to(words);
    }

    /** What changes when the numbers do. */
    int version() {
        return heap.version();
    }

    long bytes() {
        return (long) Sizeof.cl_int * words.length;
    }

    /** To the struct with the numbers as they are now. Allocates nothing. */
    Pointer pointer() {
        heap.copyNumbers(words, words.length - Substeps.NUMBERS);
        return toWords;
    }
}
