package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.Tuning;
import java.util.ArrayList;
import java.util.List;

/** Host code of {@code kernels/solve.cl}: a pass over the contacts, a tiling at a time. */
final class Solve {
    private final Session session;
    private final Program program;
    /** The first tiling with what comes before it, where a substep does and where none does. */
    private final Kernel moveAndFirst;

    private final Kernel kickAndFirst;
    private final List<Kernel> tilings = new ArrayList<>();
    private int count;
    private boolean fused;

    Solve(Session session, Program program) {
        this.session = session;
        this.program = program;
        moveAndFirst = new Kernel(session, program, "c2d_solve_first");
        kickAndFirst = new Kernel(session, program, "c2d_solve_first");
    }

    /** What every kernel that visits contacts begins with, {@code C2D_SOLVE}. */
    static Object[] known(SmallWorld world) {
        SmallBuffers buffers = world.buffers();
        Turn now = world.now();
        Turn free = world.before();
        return new Object[] {
            now.body,
            now.id,
            buffers.kicked,
            buffers.walls,
            buffers.rule,
            now.memory,
            free.memory,
            buffers.capacity(),
            free.body,
            buffers.tileStart,
            buffers.tileColours,
            world.state().status
        };
    }

    void bind(SmallWorld world) {
        Turn free = world.before();
        Tiles tiles = world.tiles();
        Object[] known = known(world);
        fused = world.fused();
        Object[] local = {
            new Kernel.Local(32 * Tuning.TILE_CIRCLES),
            new Kernel.Local(4 * Tuning.TILE_CIRCLES),
            new Kernel.Local(8 * Tuning.TILE_CONTACTS),
            new Kernel.Local(Tuning.TILE_CONTACTS)
        };
        moveAndFirst
                .arguments(known, free.id, free.other, tiles.tiles, 1, local)
                .groups(tiles.count(0), world.firstTileGroup());
        kickAndFirst
                .arguments(known, free.id, free.other, tiles.tiles, 0, local)
                .groups(tiles.count(0), world.firstTileGroup());
        count = tiles.tilings;
        for (int tiling = 0; tiling < count; tiling++) {
            if (tiling == tilings.size()) {
                tilings.add(new Kernel(session, program, "c2d_solve"));
            }
            tilings.get(tiling).arguments(known, tiles.first(tiling)).groups(tiles.count(tiling), world.tileGroup());
        }
    }

    /** Substeps, as {@link io.github.circles2d.pipeline.SmallStages#solve} says. */
    void run(int substeps, Integrate integrate) {
        for (int substep = 0; substep < substeps; substep++) {
            if (fused) {
                (substep > 0 ? moveAndFirst : kickAndFirst).launch();
            } else {
                integrate.run(substep > 0, true);
                tilings.get(0).launch();
            }
            for (int tiling = 1; tiling < count; tiling++) {
                tilings.get(tiling).launch();
            }
        }
    }
}
