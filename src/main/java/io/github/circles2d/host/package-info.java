/**
 * The host device: the stages in plain Java. At once what machines without OpenCL run on, the specification of the
 * kernels, one class a kernel file, and the oracle that each kernel is tested against, bit for bit. Internal: not part of
 * the public API, may change in any release.
 */
package io.github.circles2d.host;
