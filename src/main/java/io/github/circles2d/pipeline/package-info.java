/**
 * What both devices share: the order of the stages, the cells, the tuning constants. Internal: not part of the public
 * API, may change in any release. Nothing here takes or returns {@code null}.
 */
package io.github.circles2d.pipeline;
