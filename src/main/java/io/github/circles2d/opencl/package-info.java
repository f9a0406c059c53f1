/**
 * The OpenCL device: one class a stage, each the host code of the kernel file of the same name. Every call of OpenCL goes
 * through {@link io.github.circles2d.opencl.ClApi}, whose every status is checked; every handle has one owner, which
 * releases it. Internal: not part of the public API, may change in any release.
 */
package io.github.circles2d.opencl;
