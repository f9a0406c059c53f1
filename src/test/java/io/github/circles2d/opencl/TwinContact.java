package io.github.circles2d.opencl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.pipeline.CellGrid;
import io.github.circles2d.pipeline.Stages;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** A contact as a stage left it; translations as bits. */
record TwinContact(int i, int j, int x, int y) {
    private static final Comparator<TwinContact> BY_PAIR =
            Comparator.comparingInt(TwinContact::i).thenComparingInt(TwinContact::j);

    /** The contacts of the last detect, in the order they were found in. */
    static List<TwinContact> found(Stages stages) {
        int count = Math.toIntExact(stages.await().contacts());
        IntBuffer pairs = ByteBuffer.allocateDirect(8 * count)
                .order(ByteOrder.nativeOrder())
                .asIntBuffer();
        FloatBuffer translations = TwinState.direct(2 * count);
        stages.contacts(0, count, pairs, translations);
        List<TwinContact> contacts = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            contacts.add(new TwinContact(
                    pairs.get(2 * k),
                    pairs.get(2 * k + 1),
                    Float.floatToRawIntBits(translations.get(2 * k)),
                    Float.floatToRawIntBits(translations.get(2 * k + 1))));
        }
        return contacts;
    }

    static List<TwinContact> sorted(List<TwinContact> contacts) {
        return contacts.stream().sorted(BY_PAIR).toList();
    }

    /** The lists that colour must make of the contacts: by owner cell, then by pair. */
    static Map<Integer, List<TwinContact>> byOwner(List<TwinContact> contacts, TwinState state, CellGrid cells) {
        Map<Integer, List<TwinContact>> lists = new TreeMap<>();
        for (TwinContact contact : sorted(contacts)) {
            int a = cells.cell(state.circle.get(4 * contact.i), state.circle.get(4 * contact.i + 1));
            int b = cells.cell(state.circle.get(4 * contact.j), state.circle.get(4 * contact.j + 1));
            // the lower row, then the lower column
            boolean first = a / cells.columns() < b / cells.columns()
                    || (a / cells.columns() == b / cells.columns() && a % cells.columns() <= b % cells.columns());
            lists.computeIfAbsent(first ? a : b, cell -> new ArrayList<>()).add(contact);
        }
        return lists;
    }

    /** The lists that the device holds. */
    static Map<Integer, List<TwinContact>> onDevice(Contacts buffers, List<TwinContact> found, int cells) {
        IntBuffer head = read(buffers.head, cells);
        IntBuffer next = read(buffers.next, found.size());
        Map<Integer, List<TwinContact>> lists = new TreeMap<>();
        int linked = 0;
        for (int cell = 0; cell < cells; cell++) {
            for (int k = head.get(cell); k != -1; k = next.get(k)) {
                lists.computeIfAbsent(cell, c -> new ArrayList<>()).add(found.get(k));
                assertTrue(++linked <= found.size(), "a list goes round in circles");
            }
        }
        assertEquals(found.size(), linked, "contacts in lists");
        return lists;
    }

    private static IntBuffer read(DeviceBuffer from, int count) {
        IntBuffer to = ByteBuffer.allocateDirect(4 * count)
                .order(ByteOrder.nativeOrder())
                .asIntBuffer();
        from.read(0, to, 4L * count);
        return to;
    }

    /** No circle is in the lists of two owners of one colour, and the colours' owners are all cells, each once. */
    static void checkColours(Map<Integer, List<TwinContact>> lists, CellGrid cells) {
        int visited = 0;
        for (int colour = 0; colour < CellGrid.COLOURS; colour++) {
            Map<Integer, Integer> ownerOf = new HashMap<>();
            for (int item = 0; item < cells.owners(colour); item++) {
                int owner = cells.owner(item, colour);
                for (TwinContact contact : lists.getOrDefault(owner, List.of())) {
                    visited++;
                    for (int circle : new int[] {contact.i, contact.j}) {
                        Integer other = ownerOf.put(circle, owner);
                        assertTrue(other == null || other == owner, "circle " + circle + ", colour " + colour);
                    }
                }
            }
        }
        assertEquals(lists.values().stream().mapToInt(List::size).sum(), visited, "contacts that resolve visits");
    }
}
