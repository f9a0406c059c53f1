package io.github.circles2d.host;

import io.github.circles2d.pipeline.Changes;
import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Motion;
import io.github.circles2d.pipeline.Population;
import io.github.circles2d.pipeline.SmallStages;
import io.github.circles2d.pipeline.Status;
import io.github.circles2d.pipeline.StepSums;
import io.github.circles2d.pipeline.Substeps;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.Workers;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.FloatBuffer;

/** The stages of one world of small steps in plain Java. Nothing queues up: every call is done when it returns. */
public final class HostSmallStages implements SmallStages {
    private final SmallState state = new SmallState();
    private final Workers workers = new Workers(Tuning.HOST_ITEMS, Integer.MAX_VALUE);
    private final SmallContacts contacts = new SmallContacts();
    private final Grid grid;
    private final Find find;
    private final Match match;
    private final Integrate integrate;
    private final Solve solve;
    private final Batch batch;
    private final WorldConfig config;
    private final Status status = new Status();
    private int detections;

    public HostSmallStages(WorldConfig config) {
        this.config = config;
        grid = new Grid(state, workers);
        find = new Find(config, state, contacts, workers);
        match = new Match(state, contacts, workers);
        integrate = new Integrate(state, workers);
        batch = new Batch(state, contacts, workers);
        solve = new Solve(state, contacts, batch);
    }

    @Override
    public void upload(Population population, FloatBuffer velocities, Levels[] levels, Levels used) {
        state.upload(population, velocities, used);
        contacts.ensureCircles(state.id.length);
    }

    @Override
    public void use(Levels levels) {
        state.levels = levels;
    }

    @Override
    public void velocities(FloatBuffer velocities, Changes changed) {
        state.velocities(velocities, changed);
    }

    @Override
    public void download(FloatBuffer transforms, FloatBuffer velocities) {
        state.published.download(transforms, velocities);
    }

    @Override
    public void begin(Substeps substeps, float ratio, boolean lists) {
        state.substeps = substeps;
        state.motion.begin(lists);
        if (ratio != 1) {
            solve.rescale(ratio);
        }
    }

    @Override
    public void detect(float horizon, float slack) {
        grid.run();
        find.run(horizon, slack);
        batch.run();
        match.run();
        detections++;
    }

    @Override
    public void integrate() {
        integrate.run(true, false, false);
    }

    @Override
    public void solve(int count) {
        for (int substep = 0; substep < count; substep++) {
            integrate.run(substep > 0, true, false);
            solve.run();
        }
    }

    @Override
    public void publish() {
        integrate.run(true, false, true);
    }

    @Override
    public Motion motion() {
        return state.motion;
    }

    @Override
    public Status await(boolean reading) {
        int done = detections;
        detections = 0;
        return status.set(contacts.listStart[state.circles], false, done);
    }

    @Override
    public void makeRoom(long needed) {
        throw new IllegalStateException("plain Java makes room at once");
    }

    @Override
    public StepSums sums() {
        return Stats.ofLists(config, state, contacts);
    }

    @Override
    public long bytes() {
        return 0;
    }

    @Override
    public void close() {}
}
