package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Tuning;
import java.util.ArrayList;
import java.util.List;

/** Host code of {@code kernels/solve.cl}: one pass over the contacts, a level and a colour at a time. */
final class Solve {
    private final Session session;
    private final Program program;
    private final List<Kernel> colours = new ArrayList<>();
    private final Kernel narrow;
    private int launches;
    private boolean narrows;

    Solve(Session session, Program program) {
        this.session = session;
        this.program = program;
        narrow = new Kernel(session, program, "c2d_solve_narrow");
    }

    void bind(SmallWorld world) {
        SmallBuffers buffers = world.buffers();
        Turn now = world.now();
        Levels levels = world.levels();
        Object[] known = {
            now.body,
            now.id,
            buffers.kicked,
            now.listStart,
            now.other,
            now.memory,
            buffers.bucketStart,
            world.state().status,
            buffers.levels,
            buffers.rule
        };
        int wide = world.config().smallWorld() > 0 ? wideLevels(levels) : levels.count;
        launches = 0;
        narrows = wide < levels.count;
        for (int number = 0; number < wide; number++) {
            int rows = Levels.rows(number);
            for (int colour = 0; colour < 3 * rows; colour++) {
                int x = colour % 3;
                int y = colour / 3;
                int across = across(levels, number, x);
                int buckets = across * up(levels, number, y);
                if (launches == colours.size()) {
                    colours.add(new Kernel(session, program, "c2d_solve"));
                }
                colours.get(launches++)
                        .arguments(known, number, x, y, rows, across, buckets)
                        .range(buckets, Math.min(world.group(), Tuning.SOLVE_WORK_GROUP));
            }
        }
        narrow.arguments(known, wide, levels.count).range(1, world.oneGroup());
    }

    /** Buckets of one colour in a row. */
    private static int across(Levels levels, int number, int x) {
        return (levels.table[Levels.at(number) + Levels.WIDTH] - x + 2) / 3;
    }

    /** Rows with buckets of one colour. */
    private static int up(Levels levels, int number, int y) {
        int rows = Levels.rows(number);
        return (levels.table[Levels.at(number) + Levels.HEIGHT] - y + rows - 1) / rows;
    }

    /** Levels up to the last that is worth launches of its own. */
    private static int wideLevels(Levels levels) {
        int wide = levels.count;
        while (wide > 0 && across(levels, wide - 1, 0) * up(levels, wide - 1, 0) <= Tuning.NARROW) {
            wide--;
        }
        return wide;
    }

    void run() {
        for (int k = 0; k < launches; k++) {
            colours.get(k).launch();
        }
        if (narrows) {
            narrow.launch();
        }
    }
}
