package io.github.circles2d.pipeline;

import io.github.circles2d.CapacityException;

/** What a device has done since the world last looked. The same object each time: a step allocates nothing. */
public final class Status {
    /** Highest colour of a contact that there is room for. */
    public static final int MOST_COLOURS = 65_535;

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

    /** What is thrown where so many circles lie on each other that their contacts have no order. */
    public static CapacityException tooDense() {
        return new CapacityException("circles lie on each other so densely that a chain of contacts takes more than "
                + (MOST_COLOURS + 1) + " turns; more substeps, or fewer circles in one place, avoid that");
    }

    /** Updates run, or of small steps detections done, since the last time it was asked, or since room was made. */
    public int updates() {
        return updates;
    }
}
