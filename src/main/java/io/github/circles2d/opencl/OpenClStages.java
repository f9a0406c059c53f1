package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.CellGrid;
import io.github.circles2d.pipeline.Changes;
import io.github.circles2d.pipeline.IndexStrategies;
import io.github.circles2d.pipeline.Population;
import io.github.circles2d.pipeline.Stages;
import io.github.circles2d.pipeline.Status;
import io.github.circles2d.pipeline.StepSums;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.List;
import java.util.Map;

/** The stages of one world on an OpenCL device. Calls queue up, in order. */
final class OpenClStages implements Stages {
    private final WorldConfig config;
    private final Session session;
    private final State state;
    final Contacts contacts;
    private final int group;
    private final int oneGroup;
    private Boolean wide;
    private Program program;
    private Update update;
    /** One of the two is null: pairs are numbered, or they are not. */
    private Detect detect;

    private Near near;
    private Colour colour;
    private Resolve resolve;
    private final Stats stats;
    private int found;
    private CellGrid cells;
    private boolean closed;

    OpenClStages(OpenClDevice device, WorldConfig config) {
        this.config = config;
        group = device.group(config);
        oneGroup = device.oneGroup(config);
        session = new Session(device);
        try {
            state = new State(session);
            contacts = new Contacts(session);
            stats = new Stats(
                    session,
                    config,
                    group,
                    () -> Program.build(
                            session,
                            Map.of(),
                            List.of(
                                    Program.functions("common.cl"),
                                    Program.file("stats.cl"),
                                    Program.file("stats_found.cl"))));
            compile(false);
        } catch (RuntimeException e) {
            session.close();
            throw e;
        }
    }

    private int pairsPerItem() {
        boolean inTurn = !session.device.asOnGpu(config) && !config.triangle();
        return inTurn ? Tuning.PAIRS_PER_ITEM_IN_TURN : Tuning.PAIRS_PER_ITEM;
    }

    /** Compiles the kernels for pair indices of 32 or 64 bits, unless they are so already. */
    private void compile(boolean wanted) {
        if (wide != null && wide == wanted) {
            return;
        }
        Program old = program;
        program = Program.build(
                session,
                Map.of(
                        "C2D_GPU", session.device.asOnGpu(config) ? 1 : 0,
                        "C2D_WIDE", wanted ? 1 : 0,
                        "C2D_TRIANGLE", config.triangle() ? 1 : 0,
                        "C2D_PAIRWISE", config.strategy().pairwise() ? 1 : 0,
                        "C2D_BLOCK", Tuning.BLOCK,
                        "C2D_PAIRS", pairsPerItem()),
                List.of(
                        Program.file("common.cl"),
                        Map.entry(
                                "index_" + config.strategy().name() + ".cl",
                                config.strategy().pairwise() ? config.strategy().kernelSource() : ""),
                        Program.file("update.cl"),
                        Program.file("detect.cl"),
                        Program.file("contact.cl"),
                        Program.file("colour.cl"),
                        Program.file("resolve.cl"),
                        Program.file("near.cl")));
        // kernels of the old program go with the session; a world crosses this line once
        update = new Update(session, program);
        if (config.strategy().pairwise()) {
            detect = new Detect(session, program, config, pairsPerItem());
        } else {
            near = new Near(session, program);
        }
        colour = new Colour(session, program);
        resolve = new Resolve(session, program);
        wide = wanted;
        if (old != null) {
            old.close();
        }
    }

    @Override
    public void upload(Population population, FloatBuffer velocities) {
        int circles = population.circles();
        compile(IndexStrategies.wide(circles));
        state.upload(population, velocities);
        cells = CellGrid.of(config, circles, population.maxRadius());
        contacts.cellStart.ensure(4L * cells.cells());
        contacts.ensure((long) Tuning.CONTACTS_PER_CIRCLE * circles + Tuning.FIRST_CONTACTS);
        bind();
    }

    private void bind() {
        update.bind(config, state, contacts, cells, group);
        if (near != null) {
            near.bind(state, contacts, cells, group, oneGroup);
        } else {
            detect.bind(state, contacts, group);
        }
        colour.bind(state, contacts, cells, config.restitution(), group, oneGroup);
        resolve.bind(config, state, contacts, cells, group, oneGroup);
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
        state.changes();
        update.run();
    }

    @Override
    public void detect() {
        if (near != null) {
            near.run();
        } else {
            detect.run();
        }
    }

    private boolean small() {
        return state.circles <= config.smallWorld();
    }

    /** In a small world, one work-group does this together with resolve. */
    @Override
    public void colour() {
        if (detect != null) {
            detect.collect();
        }
        if (!small()) {
            colour.run();
        }
    }

    @Override
    public void resolve() {
        state.changes();
        if (small()) {
            resolve.runSmall();
        } else {
            resolve.run();
        }
        session.flush();
    }

    @Override
    public Status await(boolean reading) {
        Status status = state.await(reading);
        found = (int) status.contacts();
        return status;
    }

    @Override
    public void makeRoom(long needed) {
        contacts.makeRoom(needed);
        state.clearStatus();
        bind();
    }

    @Override
    public StepSums sums() {
        return stats.ofFound(state, contacts.found, found);
    }

    @Override
    public void contacts(int from, int count, IntBuffer to) {
        contacts.found.read(Contacts.BYTES * from, to, Contacts.BYTES * count);
    }

    @Override
    public long bytes() {
        return session.bytes();
    }

    @Override
    public void close() {
        if (!closed) {
            closed = true;
            session.close();
        }
    }
}
