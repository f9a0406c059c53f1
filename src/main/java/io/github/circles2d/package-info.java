/**
 * Rigid circles in two dimensions, on any OpenCL device or in plain Java, with the same bits on each.
 *
 * <p>Start at {@link io.github.circles2d.Circles2D}. Lengths are world units, times seconds; masses take any unit. No
 * method takes or returns {@code null}. Bad arguments throw {@link java.lang.IllegalArgumentException} that names the
 * argument, its value and what is allowed, and change nothing; what goes wrong on a device throws a
 * {@link io.github.circles2d.Circles2DException}. The packages below this one are internal.
 */
package io.github.circles2d;
