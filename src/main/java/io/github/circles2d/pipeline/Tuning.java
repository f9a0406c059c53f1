package io.github.circles2d.pipeline;

/** Every tuning constant and every limit of the library, each with its unit and range. */
public final class Tuning {
    /** Largest coordinate of the bounds, world units: squares of distances stay far from overflow. */
    public static final float MAX_COORDINATE = 1e9f;

    /** Radii, world units: squares of overlaps stay far from underflow. */
    public static final float MIN_RADIUS = 1e-9f;

    public static final float MAX_RADIUS = 1e9f;

    /** Masses, in any unit: a chain of collisions from the heaviest to the lightest stays finite. */
    public static final float MIN_MASS = 1e-9f;

    public static final float MAX_MASS = 1e9f;

    /** Largest component of a velocity that a caller may set, world units a second. */
    public static final float MAX_SPEED = 1e9f;

    /** Largest component of gravity, world units / s^2. */
    public static final float MAX_GRAVITY = 1e9f;

    /** Time steps, seconds. Usual: 1/240 to 1/30. */
    public static final float MIN_TIME_STEP = 1e-9f;

    public static final float MAX_TIME_STEP = 1e3f;

    /** Most circles of one world: what fits the largest direct buffer of Java, 16 bytes a circle. */
    public static final int MAX_CIRCLES = (Integer.MAX_VALUE - 64) / 16;

    /** Room for circles that a world starts with when no capacity is named, circles. Any value > 0. */
    public static final int FIRST_CIRCLES = 256;

    /** Room for contacts that a world starts with, contacts a circle. 2 to 8: a dense pile has 2 to 3. */
    public static final int CONTACTS_PER_CIRCLE = 3;

    /** Room for contacts added to that, contacts: small worlds can start in one heap. */
    public static final int FIRST_CONTACTS = 1024;

    /** How far buffers grow beyond what is needed, a factor. 1.1 to 2. */
    public static final double GROWTH = 1.5;

    /**
     * How much wider a cell is than the largest circle, a fraction. At {@link #MAX_CELLS_PER_AXIS} cells the rounding
     * of two cell coordinates stays below a half of it, so circles that touch always lie in neighbouring cells.
     */
    public static final float CELL_MARGIN = 1f / 64;

    /** Most cells along one axis. At most 2^14: see {@link #CELL_MARGIN}. */
    public static final int MAX_CELLS_PER_AXIS = 1 << 14;

    /** Most cells for each circle, so that memory grows with the circles and not with the area. 1 to 8. */
    public static final int CELLS_PER_CIRCLE = 2;

    /** Most pairs of one launch: a driver's watchdog allows some seconds, this takes milliseconds. 2^20 to 2^30. */
    public static final long PAIRS_PER_LAUNCH = 1L << 28;

    /** Pairs that a work-item of detect looks at, {@code C2D_PAIRS}. 1 to 16: on a GPU 4 are an eighth faster than 1. */
    public static final int PAIRS_PER_ITEM = 4;

    /** The same where a processor lists contacts, one pair after the other. 1 to 64. */
    public static final int PAIRS_PER_ITEM_IN_TURN = 32;

    /** Largest single buffer of the triangle, bytes. 2^20 to 2^30. */
    public static final long TRIANGLE_BYTES = 1L << 30;

    /** Largest look-up table of a slice of pairs, bytes: the host fills as large a buffer first. 2^20 to 2^30. */
    public static final long TABLE_BYTES = 1L << 28;

    /** Pairs of the triangle that share a mark, {@code C2D_BLOCK}. 64 to 4,096. */
    public static final int BLOCK = 64;

    /** Largest state that is read whole when its step is waited for, bytes. 0 to 2^22: one transfer less, but one for every step. */
    public static final long ONE_TRANSFER_BYTES = 1L << 20;

    /**
     * Largest part of a state that is written or read back in one go through pinned memory, of which a world then has so much, bytes. At
     * least {@link #ONE_TRANSFER_BYTES}, 2^20 to 2^26: less means more transfers, more pins memory for next to nothing.
     */
    public static final int STAGING_BYTES = 1 << 24;

    /**
     * Fewest circles of a world on an OpenCL device that are given to another thread to copy to or from {@link #STAGING_BYTES}: 16 bytes
     * and 8 each. 2^12 to 2^18: waking it takes some 20 us.
     */
    public static final int COPY_CIRCLES = 1 << 14;

    /** Threads that copy at most, the one that waits for it included. 1 to 64: a few use up what memory gives. */
    public static final int COPY_THREADS = 8;

    /** How often a world's circles are copied by one thread before several do, times: the JVM has compiled it by then. 0 to 100. */
    public static final int COPIES_ALONE = 8;

    /**
     * Circles that a method goes through in one call where a world is new, 16 to 256: what is called often a young JVM compiles after some
     * thousand of them, what goes round for long only after 60,000.
     */
    public static final int CIRCLES_A_CALL = 64;

    /** Circles of which, where the velocity of one is set, those of all are sent to the device. 1 to 2^14: a bit for so many. */
    public static final int CHANGED_TOGETHER = 1 << 8;

    /** Circles between two such up to which they are sent too: a transfer takes as long as 8 bytes of some 16,000. 0 to 2^16. */
    public static final int CHANGED_APART = 1 << 14;

    /** How often kernels are compiled at most where a driver fails without saying why, times. 1 to 10. */
    public static final int BUILDS = 3;

    /** Steps that may wait in the queue before the caller waits for them, steps. 8 to 256. */
    public static final int STEPS_IN_FLIGHT = 64;

    /** Work-items of a group, on a GPU and on a CPU. Powers of two, 32 to 1,024. */
    public static final int GPU_WORK_GROUP = 256;

    public static final int CPU_WORK_GROUP = 256;

    /** Circles up to which launches are saved at the price of larger kernels. 0 (never) to 10^6. */
    public static final int FEW_CIRCLES = 200_000;

    /** Work-items of a group that does a tile, about as many as it has contacts of one colour, on a GPU. 32 to 256. */
    public static final int GPU_TILE_GROUP = 32;

    /** The same of the first tiling, whose tiles have most of the contacts. */
    public static final int GPU_FIRST_TILE_GROUP = 256;

    /** The same where such a tile gets its colours: twice as many groups at a time. */
    public static final int GPU_COLOUR_GROUP = 128;

    /** Registers of a work-item that solves, where a compiler can be told. 40 to 128. */
    public static final int GPU_SOLVE_REGISTERS = 56;

    /** Both on a CPU. */
    public static final int CPU_TILE_GROUP = 1;

    /** Work-items of a launch of one group, which scans cells or does a small world, on a GPU. 64 to 1,024. */
    public static final int GPU_ONE_GROUP = 640;

    /** The same on a CPU, where one work-item after the other runs anyway. */
    public static final int CPU_ONE_GROUP = 1;

    /** Largest world, in circles, that one work-group colours and resolves. 0 (never) to some ten thousand. */
    public static final int SMALL_WORLD = 4096;

    // ---- IndexStrategy.auto()

    /** Circles of a trial at most: beyond, what is fastest is the same. 2^12 to 2^20. */
    public static final int AUTO_TRIAL_CIRCLES = 1 << 16;

    /** Circles up to which strategies by pairs are tried, besides the grid. 2^10 to 2^15. */
    public static final int AUTO_TRIAL_PAIRWISE = 1 << 12;

    /** Rounds of a trial, of which the quickest counts, and steps of a round. 2 to 10. */
    public static final int AUTO_TRIAL_ROUNDS = 4;

    public static final int AUTO_TRIAL_STEPS = 3;

    // ---- Solver.SMALL_STEPS

    /** Most substeps of a step. */
    public static final int MAX_SUBSTEPS = 512;

    /** Substeps chosen where none are asked for: fewest in a small and in a large world, and most. 4 to 512. */
    public static final int AUTO_FEWEST_SMALL = 16;

    public static final int AUTO_FEWEST = 8;

    public static final int AUTO_MOST = 128;

    /** Circles up to which a world is small in that sense: its substeps are cheap, and thin columns need them. */
    public static final int AUTO_SMALL = 8000;

    /** Substeps chosen come in multiples of this, so that they seldom change. 1 to 8. */
    public static final int AUTO_UNIT = 4;

    /**
     * How deep a pile may sink, a pure number: H g h^2 / (1.8 r^2) for a pile H high and substeps of h. The mean overlap
     * is 0.12 R times its power 0.6, less for the largest: 0.069 for 0.024 R, 0.0505 for 0.02 R.
     */
    public static final double AUTO_DEPTH = 0.069;

    /** Share of the area that circles in a pile cover. */
    public static final double PILE_DENSITY = 0.82;

    /** Farthest that a circle should go in a substep, radii, as far as that takes no more substeps than the next. 0.25 to 1. */
    public static final double AUTO_TRAVEL = 0.5;

    public static final double AUTO_MOST_FOR_SPEED = 64;

    /** Share of the last change that the next impulse of a contact is extrapolated by. 0 to 0.5: more, and piles boil. */
    public static final float EXTRAPOLATE = 0.4f;

    /** The same where one radius is more than {@link #UNEVEN} times the other. */
    public static final float EXTRAPOLATE_UNEVEN = 0.2f;

    public static final float UNEVEN = 2;

    /** Overlap, in smaller radii, beyond which nothing is extrapolated: the normal turns too fast. */
    public static final float DEEP = 0.25f;

    /**
     * How far the normal of a contact may turn in a substep, radians, for its impulse to be worth something in the next. 0.5
     * to 1.2: an impulse along a normal that has turned feeds energy to the next one.
     */
    public static final float TURN = 1f;

    /** Share of an overlap that a substep undoes. 0.1 to 0.4. */
    public static final float PUSH = 0.2f;

    /** Overlap that is left alone, smaller radii. 0.002 to 0.02. */
    public static final float SLOP = 0.01f;

    /** Most that overlap is undone by in a substep, smaller radii. 0.05 to 0.4: with less, circles stay caught in each other. */
    public static final float PUSH_MOST = 0.2f;

    /** Approach below which nothing bounces, in what gravity adds to a velocity in a substep. 2 to 8. */
    public static final float BOUNCE_FROM = 4;

    /** Loss of velocity of circles that others carry, 1/s. 0 to 2. */
    public static final float DRAG = 0.5f;

    /** Largest impulse kept for the next substep: finite, so that two of them never make a NaN. */
    public static final float IMPULSE_MOST = 1e15f;

    /** Share of its radius that the centre of a circle always keeps from the walls. 0.25 to 1: 1 leaves walls no give. */
    public static final float INSIDE = 0.5f;

    /** How far the reach of a circle goes beyond its radius, radii: cells are 2 r (1 + this) wide. 0.25 to 1. */
    public static final float REACH = 0.5f;

    /** The same in steps where that saves detections. 0.5 to 2.5. */
    public static final float REACH_FAR = 2;

    /** How much longer a detection takes then, a factor. 1 to 2. */
    public static final float WIDER = 1.3f;

    /**
     * Circles beyond which detections follow from how fast any two close in, and not from twice the highest speed alone. A million lie in
     * each other as deep as before by that, 100,000 deeper by 2 %, 10,000 by 4 %, 2,000 by 6 %. 0 to 10^7.
     */
    public static final int CLOSING_CIRCLES = 200_000;

    /**
     * Longest time that a list of contacts of as many circles is made for where steps are shorter than this, seconds. 0 to 1/30: what a circle
     * is sent to by another is on no list until the next.
     */
    public static final float LISTED_SECONDS = 1f / 60;

    /** Gap up to which a contact is always listed, smaller radii. 0.05 to 0.2. */
    public static final float ALWAYS_NEAR = 0.1f;

    /** How far a circle may fall, from rest, before contacts are listed again, smallest radii. 0.1 to 1: more list more. */
    public static final float FALL = 0.25f;

    /**
     * How far circles may go before contacts are listed again, where those of a step are good for more than that step, smallest radii.
     * 0 (each step lists its own, unless nothing moves) to 0.5: more list more.
     */
    public static final float SKIN = 0.4f;

    /** Steps that a list should be good for where circles are so slow that {@link #SKIN} would be good for more. 2 to 100. */
    public static final int SKIN_STEPS = 50;

    /**
     * Steps up to which a world of up to {@link #ALONE_CIRCLES} goes on before the host looks at how its circles move, where a list is good
     * for as many and none can fall farther than {@link #SKIN} in them. 1 (a look after each) to 16: a look takes some 20 us of a GPU, a
     * step of such a world 80. In larger worlds circles get faster within a few steps.
     */
    public static final int STEPS_A_LOOK = 8;

    /** How many times faster circles may get until then, a factor. 2 to 10. */
    public static final float FASTER = 4;

    /** Most levels of cells. */
    public static final int LEVELS = 20;

    /** Most of the finest cells along one axis: their numbers, and twice as many, are exact in a float. */
    public static final int MAX_FINE_CELLS_PER_AXIS = 1 << 20;

    /** Cells of one level, a circle, beyond which the level is folded into a torus; and the cells of that torus. 1 to 8. */
    public static final int LEVEL_CELLS_PER_CIRCLE = 4;

    public static final int FOLDED_CELLS_PER_CIRCLE = 2;

    /** Shift of a folded level from one turn of the torus to the next, a share of its height. */
    public static final double FOLD_SHIFT = 0.309;

    /** Side of the smallest tiles, finest cells: 3, 5 or more. */
    public static final int TILE_SIDE = 8;

    /** The same where the reach is {@link #REACH_FAR}, of up to {@link #MANY} circles and of more. */
    public static final int TILE_SIDE_FAR = 5;

    public static final int TILE_SIDE_FAR_OF_MANY = 6;

    public static final int MANY = 200_000;

    /** How many times the side doubles to the tiles of the next scale. 1 to 4. */
    public static final int TILE_SCALE = 2;

    /** Fewest circles a tile of one tiling, on average, and tiles that there may be in any case. 4 to 64; 16 to 4,096. */
    public static final int CIRCLES_PER_TILE = 16;

    public static final int TILES_FEW = 64;

    /** Work-groups for tiles besides those of the step before, and an eighth of these. 1 to 1,000. */
    public static final int MORE_TILES = 8;

    /** Circles up to which a tile is solved in the local memory of a work-group. 16 to 900: 36 bytes each, of at least 32 KiB. */
    public static final int TILE_CIRCLES = 640;

    /**
     * Contacts up to which a tile of the first tiling is coloured in local memory, on a GPU. 16 to 2,000: 10 bytes each and 8 for each of
     * its circles, of which there is room for the power of two up to these contacts.
     */
    public static final int TILE_CONTACTS = 1700;

    /** Contacts up to which a tile of another tiling is coloured there. 16 to 1,400; there is room for more circles than that. */
    public static final int OTHER_TILE_CONTACTS = 400;

    /**
     * Circles up to which a world is one tile, and one work-group does most of a detection and its substeps. 0 (never) to 1,280: local
     * memory of GPUs holds no more, and to 2,500 one core of a processor takes no longer than two or sixteen.
     */
    public static final int ALONE_CIRCLES = 1280;

    /** Values up to which one work-group scans them all. 0 (never) to 10^5. */
    public static final int SCAN_FEW = 20_000;

    /** Values that one work-item scans, {@code C2D_SCAN}. 4 to 64, a multiple of 4. */
    public static final int SCAN = 8;

    /** Turns that plain Java, or a copy, waits for another thread at full speed before it yields. 0 to 10^5; a turn takes some 10 ns. */
    public static final int HOST_SPINS = 2000;

    /** How long a thread that helps waits for the next part, ns: waking one takes some 20 us. 0 to 10^6. */
    public static final long HOST_IDLE = 200_000;

    /** How long it helps at most before others that wait for Java's common pool have their turn, ns. 10^6 to 10^7. */
    public static final long HOST_STAY = 4_000_000;

    /** Fewest circles or contacts that plain Java gives to another thread: they take some 10 us. 200 to 10,000. */
    public static final int HOST_ITEMS = 500;

    /** Parts for each thread of plain Java, where some take much longer than others. 1 to 16. */
    public static final int HOST_PARTS = 4;

    /** Circles that a thread does one step after the other with, so that they stay in its nearest cache. 64 to 1,024: 32 bytes each. */
    public static final int HOST_TURN = 512;

    private Tuning() {}
}
