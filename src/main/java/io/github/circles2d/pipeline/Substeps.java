package io.github.circles2d.pipeline;

/**
 * How a step of {@link io.github.circles2d.Solver#SMALL_STEPS} is cut, and every number that its kernels need. Computed
 * once, here, so that each device starts from the same bits.
 *
 * @param count substeps of a step
 * @param seconds time of a substep
 * @param numbers what the kernels read, in the order of {@code c2d_numbers} of {@code kernels/numbers.cl}
 */
public record Substeps(int count, float seconds, float[] numbers) {
    public static final int TIME = 0;
    public static final int PER_TIME = 1;
    public static final int BOUNCE_FROM = 2;
    public static final int RESTITUTION = 3;
    public static final int PUSH = 4;
    public static final int PUSH_MOST = 5;
    public static final int SLOP = 6;
    public static final int DEEP = 7;
    public static final int EXTRAPOLATE = 8;
    public static final int EXTRAPOLATE_UNEVEN = 9;
    public static final int UNEVEN = 10;
    public static final int IMPULSE_MOST = 11;
    public static final int TURN = 12;
    public static final int SLOWED = 13;
    public static final int ALWAYS_NEAR = 14;
    public static final int RESCALE = 15;
    public static final int GAIN_X = 16;
    public static final int SPEED_X = 17;
    public static final int MIN_X = 18;
    public static final int MAX_X = 19;
    /** How much farther on the same number of the other axis is. */
    public static final int AXIS = 4;

    /** How many numbers there are. */
    public static final int NUMBERS = 24;

    /** A step of {@code count} substeps, after steps of as many. */
    public static Substeps of(WorldConfig config, int count) {
        float[] n = new float[NUMBERS];
        float time = config.timeStep() / count;
        n[TIME] = time;
        n[PER_TIME] = 1 / time;
        n[BOUNCE_FROM] = Tuning.BOUNCE_FROM * gravity(config) * time;
        n[PUSH_MOST] = Tuning.PUSH_MOST;
        n[SLOWED] = Math.max(0, 1 - Tuning.DRAG * time);
        n[GAIN_X] = config.gravityX() * time;
        n[GAIN_X + AXIS] = config.gravityY() * time;
        n[RESCALE] = 1;
        n[SPEED_X] = (config.maxX() - config.minX()) / config.timeStep();
        n[SPEED_X + AXIS] = (config.maxY() - config.minY()) / config.timeStep();
        n[MIN_X] = config.minX();
        n[MIN_X + AXIS] = config.minY();
        n[MAX_X] = config.maxX();
        n[MAX_X + AXIS] = config.maxY();
        n[RESTITUTION] = config.restitution();
        n[PUSH] = Tuning.PUSH;
        n[SLOP] = Tuning.SLOP;
        n[DEEP] = Tuning.DEEP;
        n[EXTRAPOLATE] = Tuning.EXTRAPOLATE;
        n[EXTRAPOLATE_UNEVEN] = Tuning.EXTRAPOLATE_UNEVEN;
        n[UNEVEN] = Tuning.UNEVEN;
        n[IMPULSE_MOST] = Tuning.IMPULSE_MOST;
        n[ALWAYS_NEAR] = Tuning.ALWAYS_NEAR;
        n[TURN] = Tuning.TURN;
        return new Substeps(count, time, n);
    }

    /** Gravity's size, world units / s^2. */
    public static float gravity(WorldConfig config) {
        return (float) Math.sqrt(config.gravityX() * config.gravityX() + config.gravityY() * config.gravityY());
    }

    /**
     * How many substeps suit a world. A pile sinks by what its depth says: frictionless circles level out, so the depth
     * follows from the area of the circles alone. Fast circles must not jump over others.
     *
     * @param fastest highest speed, radii a second
     */
    public static int choose(WorldConfig config, Population population, float fastest) {
        double gx = Math.abs((double) config.gravityX());
        double gy = Math.abs((double) config.gravityY());
        double g = Math.sqrt(gx * gx + gy * gy);
        double deep = 0;
        if (g > 0) {
            double width =
                    ((config.maxX() - (double) config.minX()) * gy + (config.maxY() - (double) config.minY()) * gx) / g;
            double height = population.area() / (Tuning.PILE_DENSITY * width);
            double r = population.meanRadius();
            deep = config.timeStep() * Math.sqrt(height * g / (1.8 * r * r * Tuning.AUTO_DEPTH));
        }
        double time = config.timeStep();
        double travel = (fastest + g * time / population.minRadius()) * time;
        double fast = Math.min(Tuning.AUTO_MOST_FOR_SPEED, travel / Tuning.AUTO_TRAVEL);
        int fewest = population.circles() <= Tuning.AUTO_SMALL ? Tuning.AUTO_FEWEST_SMALL : Tuning.AUTO_FEWEST;
        double most = Math.min(Tuning.AUTO_MOST, Math.max(fewest, Math.max(deep, fast)));
        return (int) Math.ceil(most / Tuning.AUTO_UNIT) * Tuning.AUTO_UNIT;
    }

    /**
     * Substeps from one detection to the next, in which no two circles from cells that are not neighbours may meet as they move now.
     * Cells are wider than circles by their reach; two circles at most at the highest speed, one of which falls while the other
     * rests, use that up. Among many, some of which others always throw to and fro, the highest speed says little: there the
     * box of all velocities bounds how fast two close in, though a bounce may part from it; few settle better with more
     * detections. Gravity alone should not make neighbours of many. Of short steps of many there can be more than such a step has: {@link #carried}.
     */
    public int perDetection(WorldConfig config, Population population, Motion motion, Levels levels) {
        boolean many = many(population);
        boolean outlast = outlast(config, population);
        float gravity = gravity(config) / population.minRadius();
        float closing = motion.closing();
        int substeps = outlast ? Math.min(Tuning.MAX_SUBSTEPS, Math.round(Tuning.LISTED_SECONDS / seconds)) : count;
        while (substeps > 1) {
            float time = substeps * seconds;
            float wait = config.timeStep() - (outlast ? seconds : time);
            float fall = 0.5f * gravity * time * time;
            boolean apart = nearer(gravity, 2 * motion.fastest(), wait, time) <= 2 * levels.reach
                    || many && nearer(gravity(config), closing, wait, time) <= levels.room;
            if (apart && fall <= Tuning.FALL) {
                break;
            }
            substeps--;
        }
        return substeps;
    }

    private static boolean many(Population population) {
        return population.circles() > Tuning.CLOSING_CIRCLES;
    }

    /**
     * Whether lists of contacts outlast a step: those of many circles, where steps are short. In one of 1/60 s a million that stand take as
     * long either way, and those that land settle worse with fewer lists.
     */
    static boolean outlast(WorldConfig config, Population population) {
        return many(population) && config.timeStep() < Tuning.LISTED_SECONDS;
    }

    /**
     * How many substeps a step can begin with before it lists contacts: those {@code left} of the ones that the last list was made for, or
     * fewer where circles have got faster.
     *
     * @param already how much nearer two may have come since, world units: {@link #nearer(WorldConfig, Motion, int)}
     */
    int carried(WorldConfig config, Motion motion, Levels levels, int left, float already) {
        float gravity = gravity(config);
        float closing = motion.closing();
        int substeps = Math.min(left, count);
        while (substeps > 0 && already + nearer(gravity, closing, 0, substeps * seconds) > levels.room) {
            substeps--;
        }
        return substeps;
    }

    /** How much nearer two circles may come in the substeps of a step from {@code first} on, world units. */
    float nearer(WorldConfig config, Motion motion, int first) {
        return nearer(gravity(config), motion.closing(), first * seconds, (count - first) * seconds);
    }

    /** The same in a time that begins after a {@code wait}, in the units of gravity and of how fast they close in now. */
    private static float nearer(float gravity, float closing, float wait, float time) {
        return (closing + gravity * wait) * time + 0.5f * gravity * time * time;
    }

    /**
     * How far each circle may go for the contacts that a step begins with to be good for the next step too, world units: {@link
     * Tuning#SKIN}, or less where cells are not wide enough for more. Lists of neighbours with a skin are Verlet's, Physical Review
     * 159, 1967. Two circles on none of the lists are twice that farther apart than those of a step that lists its own.
     */
    public float skin(WorldConfig config, Population population, Motion motion, Levels levels) {
        float gravity = gravity(config) / population.minRadius();
        float room = levels.reach - 0.5f * nearer(gravity, 2 * motion.fastest(), 0, config.timeStep());
        return Math.min(Tuning.SKIN, room) * population.minRadius();
    }

    /** How far gravity parts two circles, one of which rests, in some substeps, world units. */
    public float fall(WorldConfig config, int substeps) {
        float time = substeps * seconds;
        return 0.5f * gravity(config) * time * time;
    }
}
