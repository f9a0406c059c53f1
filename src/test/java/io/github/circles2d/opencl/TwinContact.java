package io.github.circles2d.opencl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.IndexStrategy;
import io.github.circles2d.pipeline.CellGrid;
import io.github.circles2d.pipeline.Stages;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
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
        int count = Math.toIntExact(stages.await(true).contacts());
        IntBuffer ints = direct(4 * count);
        stages.contacts(0, count, ints);
        List<TwinContact> contacts = new ArrayList<>();
        for (int at = 0; at < 4 * count; at += 4) {
            contacts.add(new TwinContact(ints.get(at), ints.get(at + 1), ints.get(at + 2), ints.get(at + 3)));
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
            int a = cells.cell(state.transforms.get(4 * contact.i), state.transforms.get(4 * contact.i + 1));
            int b = cells.cell(state.transforms.get(4 * contact.j), state.transforms.get(4 * contact.j + 1));
            // the lower row, then the lower column
            boolean first = a / cells.columns() < b / cells.columns()
                    || (a / cells.columns() == b / cells.columns() && a % cells.columns() <= b % cells.columns());
            lists.computeIfAbsent(first ? a : b, cell -> new ArrayList<>()).add(contact);
        }
        return lists;
    }

    /** The lists that the device holds, each contact checked to be ready to be resolved. */
    static Map<Integer, List<TwinContact>> onDevice(
            Contacts buffers, List<TwinContact> found, TwinState state, CellGrid cells, float restitution) {
        Map<Long, TwinContact> byPair = new HashMap<>();
        found.forEach(contact -> byPair.put(IndexStrategy.pack(contact.i, contact.j), contact));
        IntBuffer start = read(buffers.cellStart, cells.cells());
        IntBuffer ready = read(buffers.contact, 8 * found.size());
        Map<Integer, List<TwinContact>> lists = new TreeMap<>();
        for (int cell = 0; cell < cells.cells(); cell++) {
            int end = cell + 1 < cells.cells() ? start.get(cell + 1) : found.size();
            for (int k = start.get(cell); k < end; k++) {
                TwinContact contact = byPair.get(IndexStrategy.pack(ready.get(8 * k), ready.get(8 * k + 1)));
                assertNotNull(contact, "contact " + k + " was not found by detect");
                for (int word = 2; word < 8; word++) {
                    assertEquals(
                            Float.floatToIntBits(contact.ready(state, restitution)[word - 2]),
                            Float.floatToIntBits(Float.intBitsToFloat(ready.get(8 * k + word))),
                            "word " + word + " of " + contact);
                }
                lists.computeIfAbsent(cell, c -> new ArrayList<>()).add(contact);
            }
        }
        return lists;
    }

    /** Normal, moves and gains, by the rule of Solver.IMPULSE. */
    private float[] ready(TwinState state, float restitution) {
        float tx = Float.intBitsToFloat(x);
        float ty = Float.intBitsToFloat(y);
        float depth = (float) Math.sqrt(tx * tx + ty * ty);
        float inverseI = 1 / state.masses.get(i);
        float inverseJ = 1 / state.masses.get(j);
        float shareI = inverseI / (inverseI + inverseJ);
        float shareJ = inverseJ / (inverseI + inverseJ);
        float bounce = 1 + restitution;
        return new float[] {tx / depth, ty / depth, depth * shareI, depth * shareJ, bounce * shareI, bounce * shareJ};
    }

    private static IntBuffer direct(int ints) {
        return ByteBuffer.allocateDirect(4 * ints)
                .order(ByteOrder.nativeOrder())
                .asIntBuffer();
    }

    private static IntBuffer read(DeviceBuffer from, int count) {
        IntBuffer to = direct(count);
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
