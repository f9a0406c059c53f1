package io.github.circles2d.pipeline;

/** What a device has done since the world last looked. The same object each time: a step allocates nothing. */
public final class Status {
    private long contacts;
    private boolean stalled;
    private int updates;

    /** Says what it is from now on. */
    public Status set(long newContacts, boolean newStalled, int newUpdates) {
        contacts = newContacts;
        stalled = newStalled;
        updates = newUpdates;
        return this;
    }

    /** Contacts of the last step; where that step stalled, how many it needs room for. */
    public long contacts() {
        return contacts;
    }

    /** The last step found more contacts than there is room for; nothing was resolved or updated since. */
    public boolean stalled() {
        return stalled;
    }

    /** Updates run, or of small steps detections done, since the last time it was asked, or since room was made. */
    public int updates() {
        return updates;
    }
}
