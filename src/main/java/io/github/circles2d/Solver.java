package io.github.circles2d;

/** How contacts are resolved. */
public enum Solver {
    /**
     * The thesis' rule (chapter 3, and kernels 5 to 7 of chapter 4): each contact moves its two circles apart by the
     * translation vector, then gives them one impulse {@code J = -(1 + e) v_ab . n / (1/m_a + 1/m_b)}. One visit of
     * each contact a step.
     *
     * <p>Where the thesis is wrong or loose, this solver does what physics says. The differences, all of them:
     *
     * <ul>
     *   <li><b>Two contacts of one circle.</b> In the thesis they run at the same time and one overwrites the other.
     *       Here contacts are visited in a fixed order in which no two that share a circle run together, so each
     *       sees what the one before it did, and momentum is kept.
     *   <li><b>Shares of the translation vector.</b> The thesis moves both circles by half of it, whatever their
     *       masses. Here the shares are as the inverse masses, so that the common centre of mass stays; equal masses
     *       still take a half each. A circle pushed into a wall stops at the wall.
     *   <li><b>Circles that part already.</b> The thesis applies the impulse to them too, which pulls them together
     *       again. Here only circles that approach each other get one.
     *   <li><b>The wall bounce.</b> The thesis gives {@code e (v + g t) - 2 e v}, on both axes, when either wall is
     *       hit: with e = 1 and gravity that adds energy, and a bounce off the floor slows the sideways motion. Here
     *       the velocity after the step, along the axis of the wall alone, turns over: {@code -e (v + g t)}; and the
     *       path beyond the wall is covered at the speed after the bounce: {@code e} times as far.
     *   <li><b>Circles with one centre.</b> The thesis divides by zero. Here they part along a direction made from
     *       the two numbers of the circles, the same in every run and on every device.
     *   <li><b>The float formula.</b> See {@link IndexStrategy#formula()}.
     * </ul>
     */
    IMPULSE,

    /**
     * For piles that stand still and do not sink: the step is cut into small substeps of one pass each, since many small
     * steps converge better than many iterations of a large one (Macklin et al., "Small Steps in Physics Simulation",
     * SCA 2019).
     *
     * <p>A substep of h seconds: every circle takes up gravity, {@code v += g h}, and the impulses that its contacts
     * expect; contacts are visited once, in a fixed order in which no two that share a circle run together; walls come
     * last; then {@code x += h v}. Contacts are listed before the circles touch, as far as they can come in a step or, where they
     * are fast, in the part of it until the list is made again. Where they are slow the list has a skin as Verlet's (Physical Review
     * 159, 1967): the next step goes on with it, and so the next, as long as no circle should come farther in all than {@value
     * io.github.circles2d.pipeline.Tuning#SKIN} of the smallest radius, or less where less lasts long enough, and none is added. A
     * visit of a contact with gap s (negative where the circles overlap), normal n, approach
     * velocity v_n and the impulse l that it had already does three things:
     *
     * <ul>
     *   <li><b>Impulse.</b> {@code l' = max(0, l - (v_n + max(s, 0) / h) / (1/m_a + 1/m_b))}: the circles may close the gap,
     *       no more; the sum over the substep is clamped, not the part. For the next substep {@code l' + b (l' - l_last)}
     *       is applied at the start (warm start, extrapolated by b = {@value
     *       io.github.circles2d.pipeline.Tuning#EXTRAPOLATE}), unless the normal turns by more than a radian in that time: along
     *       another normal it would not be taken back but added to, and far too few substeps would make energy.
     *   <li><b>Restitution.</b> A contact without an impulse so far, whose circles approach faster than 4 g h before this
     *       substep's impulses, gets {@code l' = -(v_n + e v_before) / (1/m_a + 1/m_b)}. That is never repeated by a warm
     *       start.
     *   <li><b>Positions.</b> A fifth of the overlap beyond 1 % of the smaller radius is undone, at most a fifth of that
     *       radius, shared as the inverse masses. It never enters the velocities, so it adds no energy.
     * </ul>
     *
     * <p>Circles and walls may overlap by a few per cent of a radius, more while things fall fast; a centre never comes
     * nearer to a wall than half a radius. Speeds are limited to one extent of the bounds a step. Circles with one centre
     * part along a direction made from their numbers.
     *
     * <p><b>How many substeps</b> ({@link Circles2D.Builder#substeps}): the mean overlap of a pile H high of circles of
     * radius R is about 0.12 R times {@code (H g h^2 / (1.8 R^2))^0.6}. In the unit box, g = 1, 60 steps a second, circles
     * that cover 35 % of it: 16 substeps leave 0.004 R among 2,000 circles and 0.016 R among 20,000; 32 halve that. A
     * circle should not go farther than its radius in a substep, or it may slip past another. Support travels some two rows of
     * circles a substep: a pile that falls on faster than that gives way and sinks into itself for a while.
     */
    SMALL_STEPS
}
