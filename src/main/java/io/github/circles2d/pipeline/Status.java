package io.github.circles2d.pipeline;

/**
 * What a device has done since the world last looked.
 *
 * @param contacts contacts of the last step; where that step stalled, how many it needs room for
 * @param stalled the last step found more contacts than there is room for; nothing was resolved or updated since
 * @param updates updates run since the last time it was asked, or since room was made
 */
public record Status(long contacts, boolean stalled, int updates) {}
