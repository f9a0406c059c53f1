package io.github.circles2d.host;

import io.github.circles2d.pipeline.CellGrid;

/** Twin of {@code kernels/resolve.cl}: resolves the contacts in the order that colour made. */
final class Resolve {
    private final Contacts contacts;
    private final Contact contact;

    Resolve(Contacts contacts, Contact contact) {
        this.contacts = contacts;
        this.contact = contact;
    }

    void run(CellGrid cells) {
        for (int colour = 0; colour < CellGrid.COLOURS; colour++) {
            int owners = cells.owners(colour);
            for (int item = 0; item < owners; item++) {
                int cell = cells.owner(item, colour);
                for (int k = contacts.cellStart[cell]; k < contacts.cellStart[cell + 1]; k++) {
                    contact.resolve(contacts.contact, Contacts.INTS * k);
                }
            }
        }
    }
}
