package io.github.circles2d.host;

import io.github.circles2d.pipeline.CellGrid;
import io.github.circles2d.pipeline.Changes;
import io.github.circles2d.pipeline.Population;
import io.github.circles2d.pipeline.Stages;
import io.github.circles2d.pipeline.Status;
import io.github.circles2d.pipeline.StepSums;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;

/** The stages of one world in plain Java. Nothing queues up: every call is done when it returns. */
public final class HostStages implements Stages {
    private final WorldConfig config;
    private final State state = new State();
    private final Contacts contacts = new Contacts();
    private final Update update;
    private final Detect detect;
    private final Near near;
    private final Colour colour;
    private final Resolve resolve;
    private final Status status = new Status();
    private CellGrid cells;

    public HostStages(WorldConfig config) {
        this.config = config;
        update = new Update(config, state, contacts);
        detect = new Detect(config, state, contacts);
        near = new Near(state, detect);
        colour = new Colour(config, state, contacts, detect);
        resolve = new Resolve(contacts, new Contact(config, state));
    }

    @Override
    public void upload(Population population, FloatBuffer velocities) {
        state.upload(population, velocities);
        detect.prepare();
        cells = CellGrid.of(config, population.circles(), population.maxRadius());
        if (contacts.cellStart.length < cells.cells() + 1) {
            contacts.cellStart = new int[cells.cells() + 1];
        }
    }

    @Override
    public void velocities(FloatBuffer velocities, Changes changed) {
        state.velocities(velocities, changed);
    }

    @Override
    public void download(FloatBuffer transforms, FloatBuffer velocities) {
        state.download(transforms, velocities);
    }

    @Override
    public void update() {
        update.run();
    }

    @Override
    public void detect() {
        if (config.strategy().pairwise()) {
            detect.run();
        } else {
            near.run(cells);
        }
    }

    @Override
    public void colour() {
        colour.run(cells);
    }

    @Override
    public void resolve() {
        resolve.run(cells);
    }

    @Override
    public Status await(boolean reading) {
        return status.set(contacts.count, false, 0);
    }

    @Override
    public void makeRoom(long needed) {
        throw new IllegalStateException("plain Java makes room at once");
    }

    @Override
    public void contacts(int from, int count, IntBuffer to) {
        to.put(0, contacts.found, Contacts.INTS * from, Contacts.INTS * count);
    }

    @Override
    public StepSums sums() {
        return Stats.ofFound(config, state, contacts);
    }

    @Override
    public long bytes() {
        return 0;
    }

    @Override
    public void close() {}
}
