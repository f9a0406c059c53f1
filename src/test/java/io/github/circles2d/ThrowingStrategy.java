package io.github.circles2d;

import java.nio.ByteBuffer;

/** A strategy of the user, {@link IndexStrategy#folded} but for a table that cannot be filled. */
public record ThrowingStrategy(RuntimeException thrown) implements IndexStrategy {
    @Override
    public String name() {
        return "users";
    }

    @Override
    public String kernelSource() {
        return IndexStrategy.folded().kernelSource();
    }

    @Override
    public long tableBytes(int circles, long pairs) {
        return 64;
    }

    @Override
    public void fillTable(int circles, long first, long pairs, ByteBuffer table) {
        throw thrown;
    }

    @Override
    public long pairAt(long pair, long first, int circles, ByteBuffer table) {
        return IndexStrategy.folded().pairAt(pair, first, circles, table);
    }
}
