package io.github.circles2d.opencl;

import io.github.circles2d.CapacityException;
import io.github.circles2d.OpenClException;
import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Substeps;
import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.Tuning;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import java.util.stream.Stream;
import org.jocl.Pointer;

/**
 * What small steps keep on the device, all in one buffer: {@code c2d_world} of {@code kernels/small.cl}, whose order the parts have
 * here. Of the first four there are two of each, by turns: a detection writes the ones while it reads the others, those of the
 * detection before. While it sorts, it keeps what it does not need later in those that it fills last; once it has what it needs of the
 * detection before, the parts of that one are free, and hold the order in which contacts are solved until the next.
 */
final class Heap {
    private static final System.Logger LOG = System.getLogger("io.github.circles2d");

    /** {@code batch} has three ints a contact, and ints say where. */
    static final int MOST_CONTACTS = Integer.MAX_VALUE / 3 & ~7;

    private static final int BODY = 0;
    private static final int ID = 1;
    static final int LIST_START = 2;
    private static final int OTHER = 3;
    /** Parts that there are two of, which come by turns: part p is at 2 p and 2 p + 1. */
    private static final int TURNS = 4;

    private static final int MEMORY = 4;
    private static final int FOUND = 5;
    private static final int WHERE = 6;
    private static final int WALLS = 7;
    private static final int KICKED = 8;
    private static final int FROM = 9;
    static final int BUCKET_START = 10;
    private static final int PART_SUMS = 11;
    private static final int LEVELS = 12;
    private static final int TILINGS = 13;
    static final int TILE_START = 14;
    private static final int SOLVES = 15;
    /** Of a tile: {@code C2D_SOLVES}. */
    private static final long SOLVES_BYTES = 32 * (1 + 32 / 8);

    private static final int LIVE = 16;
    private static final int PARTS = 17;

    /** What kernels count places in the heap in, bytes. */
    private static final int UNIT = 32;
    /** Where parts may begin: transfers of a work-group are as long. Between two parts there is as much at least. */
    private static final int ALIGNED = 256;
    /** What is between parts, and stays: a number in no part, be it read as an int or as a float. */
    private static final int GUARD = 0x7FC0DEAD;

    private final Session session;
    private final Pointer zero = Pointer.to(new int[1]);
    private final Pointer guard = Pointer.to(new int[] {GUARD});
    private DeviceBuffer buffer;
    /** Of every part, the second of two included: bytes, and where it begins. */
    private long[] bytes = new long[PARTS + TURNS];

    private long[] at = new long[PARTS + TURNS];
    private int capacity;
    /** Where the tables of levels and of tiles begin, of each of the levels that there are, in units from those of the first. */
    private int[] levelsAt = {0};

    private int[] tilingsAt = {0};

    /** Those of a substep, as bits, and how often they have changed. */
    private final int[] numbers = new int[Substeps.NUMBERS];

    private int version;

    Heap(Session session) {
        this.session = session;
        buffer = new DeviceBuffer(session, "world");
    }

    private static int index(int turn, int part) {
        return part < TURNS ? 2 * part + turn : part + TURNS;
    }

    /**
     * Makes room for circles, as many as {@code room}, and the cells of any of the levels; keeps what is kept from step to step. Whether
     * anything has moved.
     */
    boolean ensureCircles(Levels[] levels, int room) {
        long[] wanted = bytes.clone();
        want(wanted, BODY, 32L * room);
        want(wanted, ID, 4L * room);
        want(wanted, LIST_START, 4L * (room + 1));
        want(wanted, OTHER, 4L * room);
        want(wanted, WALLS, 16L * room);
        want(wanted, KICKED, 8L * room);
        want(wanted, FROM, 4L * room);
        long levelBytes = 0;
        long tilingBytes = 0;
        for (Levels cells : levels) {
            Tiles tiles = Tiles.of(cells);
            want(wanted, BUCKET_START, 4L * (cells.cells + 1));
            // one sum for each group, and a group may be of one work-item
            want(wanted, PART_SUMS, 4L * (Math.max(Math.max(cells.cells, tiles.parts()), room) / Tuning.SCAN + 1));
            levelBytes += 4L * cells.table.length;
            tilingBytes += 4L * tiles.table.length;
            want(wanted, TILE_START, 4L * (tiles.parts() + 1));
            want(wanted, SOLVES, SOLVES_BYTES * tiles.tiles);
            want(wanted, LIVE, 4L * (Tiles.MOST_TILINGS + tiles.tiles));
        }
        want(wanted, LEVELS, levelBytes);
        want(wanted, TILINGS, tilingBytes);
        long contacts = (long) Tuning.CONTACTS_PER_CIRCLE * levels[0].circles + Tuning.FIRST_CONTACTS;
        if (contacts > capacity) {
            // one circle more should not move all the others again and again
            wantContacts(wanted, Math.max(contacts, Math.min(MOST_CONTACTS, (long) (capacity * Tuning.GROWTH))));
        }
        return grow(wanted);
    }

    /** Writes the tables of the levels that there are and of their tiles. */
    void write(Levels[] levels, Tiles[] tiles) {
        levelsAt = write(LEVELS, Stream.of(levels).map(cells -> cells.table).toArray(int[][]::new));
        tilingsAt = write(TILINGS, Stream.of(tiles).map(all -> all.table).toArray(int[][]::new));
    }

    /** Makes room for at least so many contacts; keeps what is remembered of those there are. */
    void ensureContacts(long contacts) {
        long[] wanted = bytes.clone();
        wantContacts(wanted, contacts);
        grow(wanted);
    }

    private static void wantContacts(long[] wanted, long least) {
        if (least > MOST_CONTACTS) {
            throw new CapacityException("a step found " + least + " contacts; a world has room for " + MOST_CONTACTS);
        }
        // kernels handle them by fours
        long contacts = least + 7 & ~7;
        want(wanted, OTHER, 4 * contacts);
        want(wanted, MEMORY, 8 * contacts);
        want(wanted, FOUND, 8 * contacts);
        want(wanted, WHERE, 4 * contacts);
        // as the other turn's `batch`, three ints a contact, and `tint`, a short
        want(wanted, BODY, 12 * contacts);
        want(wanted, LIST_START, 2 * contacts);
    }

    private static void want(long[] wanted, int part, long least) {
        for (int turn = 0; turn < (part < TURNS ? 2 : 1); turn++) {
            int i = index(turn, part);
            wanted[i] = Math.max(wanted[i], least + UNIT - 1 & -UNIT);
        }
    }

    private boolean grow(long[] wanted) {
        long[] to = new long[wanted.length];
        long all = 0;
        boolean fits = true;
        for (int i = 0; i < wanted.length; i++) {
            to[i] = all;
            all = next(to[i], wanted[i]);
            fits &= wanted[i] <= bytes[i];
        }
        if (fits) {
            return false;
        }
        DeviceBuffer grown = new DeviceBuffer(session, "world");
        try {
            grown.ensure(all);
            for (int i = 0; i < wanted.length; i++) {
                grown.copy(buffer, at[i], to[i], bytes[i]);
                if (i < 2 * TURNS || i == index(0, WALLS)) {
                    grown.fill(to[i] + bytes[i], wanted[i] - bytes[i], zero);
                }
                long stop = to[i] + wanted[i];
                grown.fill(stop, next(to[i], wanted[i]) - stop, guard);
            }
        } catch (RuntimeException e) {
            // the caller may try again: what was there is still there
            grown.close();
            throw e;
        }
        buffer.close();
        buffer = grown;
        bytes = wanted;
        at = to;
        capacity = (int) (bytes[index(0, MEMORY)] / 8);
        return true;
    }

    /** Where the next part begins. */
    private static long next(long from, long count) {
        return (from + count + ALIGNED - 1 & -ALIGNED) + ALIGNED;
    }

    /**
     * Whether nothing was written between the parts: in one buffer, no tool sees a kernel that leaves its part. It is seen here if it
     * writes into the {@value #ALIGNED} bytes after its part, not if it reads there or goes farther. True where the device cannot say.
     */
    boolean intact() {
        IntBuffer between = ByteBuffer.allocateDirect(2 * ALIGNED)
                .order(ByteOrder.nativeOrder())
                .asIntBuffer();
        try {
            for (int i = 0; i < bytes.length && bytes[0] > 0; i++) {
                long stop = at[i] + bytes[i];
                long count = next(at[i], bytes[i]) - stop;
                buffer.read(stop, between, count);
                for (int k = 0; k < count / 4; k++) {
                    if (between.get(k) != GUARD) {
                        return false;
                    }
                }
            }
            return true;
        } catch (OpenClException e) {
            LOG.log(System.Logger.Level.WARNING, "nobody knows whether kernels kept to their parts", e);
            return true;
        }
    }

    /** Writes tables of whole units one after the other. Returns where each begins. */
    private int[] write(int part, int[][] tables) {
        int ints = Stream.of(tables).mapToInt(table -> table.length).sum();
        ByteBuffer copy = ByteBuffer.allocateDirect(4 * ints).order(ByteOrder.nativeOrder());
        IntBuffer to = copy.asIntBuffer();
        int[] begins = new int[tables.length];
        for (int k = 0; k < tables.length; k++) {
            begins[k] = 4 * to.position() / UNIT;
            to.put(tables[k]);
        }
        buffer.write(at[index(0, part)], Pointer.to(copy), 4L * ints);
        return begins;
    }

    /**
     * Sets the numbers of a substep, for every {@link #world}. Allocates nothing.
     *
     * @param ratio of its time to that of those before
     */
    void setNumbers(Substeps substeps, float ratio) {
        for (int k = 0; k < numbers.length; k++) {
            numbers[k] = Float.floatToRawIntBits(k == Substeps.RESCALE ? ratio : substeps.numbers()[k]);
        }
        version++;
    }

    /** Copies them. */
    void copyNumbers(int[] to, int from) {
        System.arraycopy(numbers, 0, to, from, numbers.length);
    }

    /** What changes when the numbers do. */
    int version() {
        return version;
    }

    /** Where a part begins, in units. */
    int at(int turn, int part) {
        return (int) (at[index(turn, part)] / UNIT);
    }

    /** What every kernel of small steps begins with, {@code C2D_WORLD}, at a turn, with some of the levels that there are. */
    Object[] world(int turn, int levels, State state) {
        int[] world = new int[bytes.length + 2];
        for (int i = 0; i < bytes.length; i++) {
            int own = i < 2 * TURNS ? i ^ turn : i;
            world[i] = (int) (at[own] / UNIT);
        }
        world[index(0, LEVELS)] += levelsAt[levels];
        world[index(0, TILINGS)] += tilingsAt[levels];
        world[bytes.length] = state.circles;
        world[bytes.length + 1] = capacity;
        return new Object[] {buffer, state.status, new WorldArgument(this, world)};
    }
}
