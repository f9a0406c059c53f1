package io.github.circles2d.host;

import io.github.circles2d.pipeline.Workers;

/** Twin of {@code kernels/match.cl}: gives each contact what the detection before remembers of it. */
final class Match {
    private final SmallState state;
    private final SmallContacts contacts;
    private final Workers workers;
    private final Workers.Work work = this::part;

    Match(SmallState state, SmallContacts contacts, Workers workers) {
        this.state = state;
        this.contacts = contacts;
        this.workers = workers;
    }

    void run() {
        workers.run(state.circles, work);
    }

    private void part(int part, int from, int end) {
        for (int p = from; p < end; p++) {
            int i = state.from[p];
            for (int k = contacts.listStart[p]; k < contacts.listStart[p + 1]; k++) {
                int j = state.from[contacts.other[k]];
                int old = remembered(i, j);
                old = old < 0 ? remembered(j, i) : old;
                int now = 2 * contacts.where[k];
                int before = old < 0 ? 0 : 2 * contacts.whereBefore[old];
                contacts.memory[now] = old < 0 ? 0 : contacts.memoryBefore[before];
                contacts.memory[now + 1] = old < 0 ? 0 : contacts.memoryBefore[before + 1];
            }
        }
    }

    /** Where circle j is in the list of circle i at the detection before, or -1. */
    private int remembered(int i, int j) {
        int low = contacts.listStartBefore[i];
        int end = contacts.listStartBefore[i + 1];
        int high = end;
        while (low < high) {
            int middle = low + (high - low) / 2;
            if (contacts.otherBefore[middle] < j) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low < end && contacts.otherBefore[low] == j ? low : -1;
    }
}
