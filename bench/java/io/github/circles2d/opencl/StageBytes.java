package io.github.circles2d.opencl;

import io.github.circles2d.pipeline.Levels;
import io.github.circles2d.pipeline.Population;
import io.github.circles2d.pipeline.Tiles;
import io.github.circles2d.pipeline.Tuning;
import io.github.circles2d.pipeline.WorldConfig;
import java.nio.FloatBuffer;
import java.util.BitSet;
import java.util.stream.LongStream;

/**
 * The bytes that a launch of each kernel of small steps, as worlds make it by themselves, reads and writes at least: each value of each buffer that it needs counts once
 * in each direction, in which it goes, however often the kernel comes back to it. What a work-item writes only now and then (walls, bounced
 * contacts) does not count, nor does what is the same for all. A cache as large as the buffers can make a kernel faster than a copy.
 */
final class StageBytes {
    private final long circles;
    private final long contacts;
    private final boolean pairwise;
    private final boolean few;
    private final long buckets;
    /** Buckets with circles in them. */
    private final long occupied;

    private final long tiles;
    /** Counts of contacts by tile, and of circles. */
    private final long parts;

    private final long members;
    private final double colourings;

    /**
     * What a world holds after a step.
     *
     * @param transforms (x, y, radius, angle) a circle
     * @param contacts those listed
     * @param colourings launches of {@code c2d_batch_colour} that share a detection's contacts
     */
    StageBytes(WorldConfig config, FloatBuffer transforms, int circles, long contacts, double colourings) {
        this.circles = circles;
        this.contacts = contacts;
        this.colourings = colourings;
        pairwise = config.strategy().pairwise();
        few = circles <= Tuning.FEW_CIRCLES;
        Population population = Population.of(transforms, null, circles);
        // those where speeds are such that a step takes one detection or two
        Levels levels = Levels.of(config, population, Tuning.REACH_FAR);
        Tiles all = Tiles.of(levels);
        buckets = levels.cells;
        occupied = occupied(config, levels, transforms, circles);
        tiles = all.tiles;
        parts = (long) Tiles.PARTS * all.tiles;
        members = all.parts() - parts;
    }

    private static int occupied(WorldConfig config, Levels levels, FloatBuffer transforms, int circles) {
        BitSet buckets = new BitSet(levels.cells);
        for (int i = 0; i < circles; i++) {
            int at = Levels.at(levels.levelOf(transforms.get(4 * i + 2)));
            int shift = levels.table[at + Levels.SHIFT];
            int column = levels.column(transforms.get(4 * i), config.minX()) >> shift;
            int row = levels.row(transforms.get(4 * i + 1), config.minY()) >> shift;
            buckets.set(levels.bucket(at, column, row));
        }
        return buckets.cardinality();
    }

    /** Bytes of one launch, the mean where launches differ; 0 where nothing sensible can be said. */
    double of(String kernel) {
        long n = circles;
        long k = contacts;
        return switch (kernel) {
            // circle, velocities, id, kicks to come; body
            case "c2d_load" -> (16 + 8 + 4 + 8 + 32) * n;
            // memory, walls and kicks to come, read and written
            case "c2d_rescale" -> 16 * k + (32 + 16) * n;
            // bucketStart, tileStart
            case "c2d_grid_clear" -> 4 * (buckets + parts + members);
            // body; bucket and turn; counts read and written
            case "c2d_grid_bin" -> (32 + 8) * n + 8 * occupied;
            // of three scans, those that take two launches: values read and written
            case "c2d_scan_parts", "c2d_scan_add" -> 8 * scanned(false);
            // those that take one
            case "c2d_scan_few" -> 8 * scanned(true);
            // bucket and turn, bucketStart; unsorted
            case "c2d_grid_scatter" -> (8 + 4) * n + 4 * occupied;
            // unsorted, bucket, bucketStart, body and id before; body, id, from, how far lists are filled, listStart
            case "c2d_grid_order" -> (4 + 4 + 32 + 4 + 32 + 4 + 4 + 4 + 4) * n + 4 * occupied;
            // body, bucketStart; listStart read and written; how many are kept, and they
            case "c2d_find_count" -> pairwise ? 0 : (32 + 8 + 4) * n + 4 * occupied + 4 * k;
            // body, listStart, how many are kept; they; found, other
            case "c2d_find_fill" -> pairwise ? 0 : (32 + 4 + 4) * n + (4 + 8 + 4) * k;
            // found; how far lists are filled, listStart
            case "c2d_match_order" -> 8 * k + (4 + 4) * n;
            // from, listStart before; found, other, other before, where, memory; found, batch
            case "c2d_match" -> (4 + 4) * n + (8 + 4 + 4 + 4 + 8 + 8 + 4) * k;
            // body, turn of the circles; batch, other; turn and part, code; tileStart read and written
            case "c2d_batch_count" -> (32 + 4) * n + (4 + 4 + 8 + 2) * k + 8 * (parts + members);
            // masks, turns read and written, body, members; turn and part, byTile; tileStart
            case "c2d_batch_fill" -> (8 + 4 + 32 + 4 + 4) * n + (8 + 4) * k + 4 * (parts + members);
            // byTile, code, owner, other, found; solved, memory, where; members; as if all tiles fitted into local
            // memory; shared out among the tilings
            case "c2d_batch_colour" -> ((4 + 2 + 4 + 4 + 8 + 4 + 8 + 4) * k + 4 * n) / colourings;
            // where the tiles are that are in order
            case "c2d_batch_order" -> 32 * tiles;
            // body read and written, kicked, members; solved, memory read and written, as
            // if all contacts were of this first tiling; what is left for the others is not known
            case Launches.FIRST_TILING -> (64 + 8 + 4) * n + (4 + 16) * k;
            // body read and written, id; centre, velocity: at the end of a step
            case "c2d_integrate" -> (64 + 4 + 8 + 8) * n;
            default -> 0;
        };
    }

    private double scanned(boolean inOneLaunch) {
        return LongStream.of(buckets + 1, circles + 1, parts + members + 1)
                .filter(count -> inOneLaunch == (few && count <= Tuning.SCAN_FEW))
                .average()
                .orElse(0);
    }
}
