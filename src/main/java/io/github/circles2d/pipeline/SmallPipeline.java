package io.github.circles2d.pipeline;

import java.nio.FloatBuffer;

/**
 * Calls the stages of a step of {@link io.github.circles2d.Solver#SMALL_STEPS} in order; the same for every device.
 *
 * <p>A detection that finds more contacts than there is room for stalls the step, which is taken up again from there once
 * there is room: no contact is ever dropped. How a step is cut depends on the speeds after the last, so a step waits for
 * the one before. A step that can goes on with the contacts of that one, and where circles are slow for what these are good for, several
 * do before anybody looks at how they move.
 */
public final class SmallPipeline implements Stepper {
    private final WorldConfig config;
    private final SmallStages stages;
    private Population population;
    /** Those that there are, least reach first, and the one in use. */
    private Levels[] levels;

    private Levels used;
    /** How circles moved when somebody looked last; of no circle before the first step. */
    private final Motion stepped = new Motion();
    /** The same, with what was uploaded since. */
    private final Motion uploaded = new Motion();
    /** That one of the two which holds. */
    private Motion motion = stepped;
    /** Circles have come since that step. */
    private boolean added;
    /** How far they may come with the contacts listed last, world units; none where the next step lists its own. */
    private float skin = -1;
    /** How far they may have come since. */
    private float come;

    /** Substeps that the contacts listed last are good for yet, where lists outlast a step, and how much nearer two may have come since. */
    private int left;

    private float nearer;
    /** Substeps that a step began with before its first detection. */
    private int carried;

    /** How many steps more go on with them before anybody looks at how circles move. */
    private int ahead;

    private float before;
    /** Those that there may be, fewest first: a world that chooses anew in every step should allocate nothing then. */
    private final Substeps[] known;

    private Substeps substeps;
    private int perDetection;
    private boolean inFlight;
    private long contacts;

    public SmallPipeline(WorldConfig config, SmallStages stages) {
        this.config = config;
        this.stages = stages;
        int fixed = config.substeps();
        int unit = fixed > 0 ? fixed : Tuning.AUTO_UNIT;
        known = new Substeps[fixed > 0 ? 1 : Tuning.AUTO_MOST / unit];
        for (int k = 0; k < known.length; k++) {
            known[k] = Substeps.of(config, (k + 1) * unit);
        }
    }

    @Override
    public void upload(Population circles, FloatBuffer velocities, Changes changed) {
        // as many as before have moved since only by steps: what is listed of them holds
        boolean more = population == null || circles.circles() != population.circles();
        population = circles;
        skin = more ? -1 : skin;
        added |= more;
        moves(velocities, changed);
        boolean wide = used != null && used != levels[0];
        levels = Levels.all(config, population);
        used = levels[wide ? levels.length - 1 : 0];
        stages.upload(population, velocities, levels, used);
    }

    @Override
    public void velocities(FloatBuffer velocities, Changes changed) {
        moves(velocities, changed);
        stages.velocities(velocities, changed);
    }

    /** Circles that were set to be slower count as before it, too: to know how all move, all would have to be looked at. */
    private void moves(FloatBuffer velocities, Changes changed) {
        if (ahead > 0) {
            ahead = 0;
            look();
        }
        left = 0;
        uploaded.clear();
        uploaded.add(stepped);
        if (added) {
            uploaded.anyFar();
        }
        changed.rewindMoving(population.circles());
        while (changed.next()) {
            population.motion(velocities, changed.from(), changed.end(), uploaded);
        }
        motion = uploaded;
    }

    /** The farthest that a circle is expected to come in the next step, world units: as far again, or as its speed says. */
    private float coming() {
        return Math.max(motion.moved(), motion.speed() * config.timeStep());
    }

    @Override
    public void step() {
        if (ahead > 0) {
            ahead--;
            carried = substeps.count();
        } else {
            await(false);
            cut();
        }
        stages.begin(substeps, before > 0 ? substeps.seconds() / before : 1, carried < substeps.count());
        before = substeps.seconds();
        lasts();
        if (carried > 0) {
            stages.solve(carried);
        }
        if (carried < substeps.count()) {
            if (carried > 0) {
                stages.integrate();
            }
            stages.use(used);
        }
        run(carried);
        added = false;
        inFlight = true;
    }

    /** How many substeps the step has, which of them list contacts, and how many steps more there are before anybody looks. */
    private void cut() {
        substeps = known.length == 1
                ? known[0]
                : known[Substeps.choose(config, population, motion.fastest()) / Tuning.AUTO_UNIT - 1];
        // a list was made for substeps of a time
        left = substeps.seconds() == before ? left : 0;
        carried = come + coming() <= skin ? substeps.count() : substeps.carried(config, motion, used, left, nearer);
        if (carried < substeps.count()) {
            choose();
            return;
        }
        int most = population.circles() <= Tuning.ALONE_CIRCLES ? Tuning.STEPS_A_LOOK : 1;
        for (int steps = 2; steps <= most && isGoodFor(steps); steps++) {
            ahead = steps - 1;
        }
    }

    /** Whether the contacts listed last are good for so many steps wherever their circles go in the first ones. */
    private boolean isGoodFor(int steps) {
        return come + Tuning.FASTER * steps * coming() <= skin
                && substeps.fall(config, steps * substeps.count()) <= Tuning.SKIN * population.minRadius();
    }

    /** What the step leaves of its last list. */
    private void lasts() {
        if (carried < substeps.count()) {
            int last = carried + (substeps.count() - 1 - carried) / perDetection * perDetection;
            left = last + lists(last);
            nearer = substeps.nearer(config, motion, last);
        } else {
            nearer += substeps.nearer(config, motion, 0);
        }
        left = Math.max(0, left - substeps.count());
    }

    /** Which cells the detections of a step have, how many there are, and how far circles may go before the next. */
    private void choose() {
        Levels now = levels[0];
        perDetection = perDetection(now);
        for (Levels wider : levels) {
            // wider cells where they save more detections than each gets longer, and as long as they save any
            int fewer = perDetection(wider);
            float longer = wider == used ? 1 : Tuning.WIDER;
            if (wider.reach > now.reach && detections(fewer) * longer < detections(perDetection)) {
                now = wider;
                perDetection = fewer;
            }
        }
        used = now;
        float coming = coming();
        float room = Math.min(substeps.skin(config, population, motion, now), Tuning.SKIN_STEPS * coming);
        skin = perDetection >= substeps.count() && coming <= room ? room : -1;
    }

    private int perDetection(Levels of) {
        return substeps.perDetection(config, population, motion, of);
    }

    /** Those of a step, or its share of them. */
    private float detections(int each) {
        return Substeps.outlast(config, population)
                ? substeps.count() / (float) each
                : (substeps.count() + each - 1) / each;
    }

    /** How many substeps a detection before substep {@code s} lists contacts for. */
    private int lists(int s) {
        return Substeps.outlast(config, population) ? perDetection : Math.min(perDetection, substeps.count() - s);
    }

    /** The substeps from {@code first} on, which begins with a detection, if there are any, and the end of the step. */
    private void run(int first) {
        for (int s = first; s < substeps.count(); s += perDetection) {
            if (s > first) {
                stages.integrate();
            }
            int listed = lists(s);
            stages.detect(listed * substeps.seconds(), substeps.fall(config, listed) + 2 * Math.max(0, skin));
            stages.solve(Math.min(listed, substeps.count() - s));
        }
        stages.publish();
    }

    @Override
    public void await() {
        await(true);
    }

    private void await(boolean reading) {
        if (!inFlight) {
            return;
        }
        Status status = stages.await(reading);
        int detections = status.updates();
        while (status.stalled()) {
            stages.makeRoom(status.contacts());
            run(carried + detections * perDetection);
            status = stages.await(reading);
            detections += status.updates();
        }
        contacts = status.contacts();
        inFlight = false;
        // whoever asks for the circles before changes nothing
        if (ahead == 0) {
            look();
        }
    }

    private void look() {
        Motion now = stages.motion();
        come = now.come();
        // which goes on with the next step
        stepped.clear();
        stepped.add(now);
        motion = stepped;
    }

    @Override
    public long contacts() {
        return contacts;
    }
}
