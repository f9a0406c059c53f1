package io.github.circles2d;

import io.github.circles2d.pipeline.Changes;
import io.github.circles2d.pipeline.CircleBuffers;
import io.github.circles2d.pipeline.Population;
import io.github.circles2d.pipeline.Radii;
import io.github.circles2d.pipeline.Tuning;
import java.nio.FloatBuffer;
import java.util.Objects;

/** The host's copy of the circles: what snapshots show, what is uploaded after a change. */
final class CircleState implements Snapshot {
    private int count;
    /** No step changes them. */
    private FloatBuffer masses;

    private CircleBuffers shown;
    /** What steps in the background are read back into; null without. */
    private CircleBuffers hidden;

    private final Radii radii = new Radii();
    private final Changes changes = new Changes();

    CircleState(int capacity, boolean background) {
        masses = CircleBuffers.grown(null, 1, capacity);
        shown = new CircleBuffers(capacity);
        hidden = background ? new CircleBuffers(0) : null;
    }

    /** Adds a circle and returns its slot. */
    int add(float x, float y, float radius, float mass, float vx, float vy) {
        makeRoom(1);
        int slot = count++;
        shown.transforms()
                .put(4 * slot, x)
                .put(4 * slot + 1, y)
                .put(4 * slot + 2, radius)
                .put(4 * slot + 3, 0);
        masses.put(slot, mass);
        radii.add(radius);
        setVelocity(slot, vx, vy);
        return slot;
    }

    /**
     * Adds circles and returns the slot of the first; the others follow.
     *
     * @param circles (x, y, radius, mass) of each
     * @param velocities (vx, vy) of each; null: at rest
     */
    int addAll(float[] circles, float[] velocities) {
        int more = circles.length / 4;
        makeRoom(more);
        int first = count;
        float[] few = new float[4 * Tuning.CIRCLES_A_CALL];
        float[] fewMasses = new float[Tuning.CIRCLES_A_CALL];
        for (int i = 0; i < more; i += Tuning.CIRCLES_A_CALL) {
            int end = Math.min(more, i + Tuning.CIRCLES_A_CALL);
            System.arraycopy(circles, 4 * i, few, 0, 4 * (end - i));
            takeMasses(few, fewMasses, end - i);
            shown.transforms().put(4 * (first + i), few, 0, 4 * (end - i));
            masses.put(first + i, fewMasses, 0, end - i);
        }
        // a slot that nobody has had yet is at rest
        if (velocities != null) {
            shown.velocities().put(2 * first, velocities);
        }
        changes.add(first, first + more, velocities != null);
        count += more;
        return first;
    }

    /** Takes the masses out of (x, y, radius, mass) and leaves transforms; adds the radii. */
    private void takeMasses(float[] circles, float[] to, int some) {
        for (int i = 0; i < some; i++) {
            radii.add(circles[4 * i + 2]);
            to[i] = circles[4 * i + 3];
            circles[4 * i + 3] = 0;
        }
    }

    private void makeRoom(int more) {
        int room = shown.room();
        if (more <= room - count) {
            return;
        }
        if (more > Tuning.MAX_CIRCLES - count) {
            throw new CapacityException("a world holds at most " + Tuning.MAX_CIRCLES + " circles");
        }
        double wanted = Math.max(Math.max(Tuning.FIRST_CIRCLES, count + more), room * Tuning.GROWTH);
        int grown = (int) Math.min(Tuning.MAX_CIRCLES, wanted);
        FloatBuffer moreMasses = CircleBuffers.grown(masses, 1, grown);
        shown.grow(grown);
        masses = moreMasses;
    }

    void setVelocity(int slot, float vx, float vy) {
        shown.velocities().put(2 * slot, vx).put(2 * slot + 1, vy);
        changes.add(slot, vx != 0 || vy != 0);
    }

    /** Those that are not as the last step left them: cleared with the next. */
    Changes changes() {
        return changes;
    }

    /** What is shown. */
    CircleBuffers shown() {
        return shown;
    }

    /** The other set, with room for what a step in the background needs; that step must not allocate. */
    CircleBuffers reserveHidden() {
        hidden.reserve(shown.room());
        return hidden;
    }

    /** Shows the other set, and returns the one that was shown. */
    CircleBuffers swap() {
        CircleBuffers before = shown;
        shown = hidden;
        hidden = before;
        return before;
    }

    /** The circles that are shown. */
    Population population() {
        return radii.population(shown.transforms(), masses);
    }

    /** FNV-1a, 64 bits, over the raw bits in slot order, 32 bits at a time. */
    long hash() {
        FloatBuffer transforms = shown.transforms();
        FloatBuffer velocities = shown.velocities();
        long hash = 0xcbf29ce484222325L;
        for (int slot = 0; slot < count; slot++) {
            for (int k = 0; k < 3; k++) {
                hash = hash(hash, transforms.get(4 * slot + k));
            }
            hash = hash(hash, masses.get(slot));
            for (int k = 0; k < 2; k++) {
                hash = hash(hash, velocities.get(2 * slot + k));
            }
        }
        return hash;
    }

    private static long hash(long before, float value) {
        return (before ^ Float.floatToRawIntBits(value) & 0xFFFFFFFFL) * 0x100000001b3L;
    }

    private float transform(int slot, int number) {
        return shown.transforms().get(4 * Objects.checkIndex(slot, count) + number);
    }

    private float velocity(int slot, int number) {
        return shown.velocities().get(2 * Objects.checkIndex(slot, count) + number);
    }

    @Override
    public int count() {
        return count;
    }

    @Override
    public float x(int slot) {
        return transform(slot, 0);
    }

    @Override
    public float y(int slot) {
        return transform(slot, 1);
    }

    @Override
    public float radius(int slot) {
        return transform(slot, 2);
    }

    @Override
    public float mass(int slot) {
        return masses.get(Objects.checkIndex(slot, count));
    }

    @Override
    public float vx(int slot) {
        return velocity(slot, 0);
    }

    @Override
    public float vy(int slot) {
        return velocity(slot, 1);
    }

    @Override
    public long circleAt(int slot) {
        return Objects.checkIndex(slot, count);
    }

    @Override
    public FloatBuffer transforms() {
        return shown.transformsView(count);
    }

    @Override
    public FloatBuffer velocities() {
        return shown.velocitiesView(count);
    }
}
