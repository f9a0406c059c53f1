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
    IMPULSE
}
