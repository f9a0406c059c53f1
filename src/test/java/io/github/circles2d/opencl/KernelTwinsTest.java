package io.github.circles2d.opencl;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.CollisionStore;
import io.github.circles2d.TestDevices;
import io.github.circles2d.host.HostStages;
import io.github.circles2d.pipeline.CellGrid;
import io.github.circles2d.pipeline.Stages;
import io.github.circles2d.pipeline.WorldConfig;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Each kernel and its twin in package host end in the same bits, stage by stage, on random worlds. */
class KernelTwinsTest {
    private static final int[] COUNTS = {0, 1, 2, 63, 64, 65, 1000};
    private static final int STEPS = 3;

    private final OpenClDevice openCl = (OpenClDevice) TestDevices.openClInside();

    static List<TwinCase> cases() {
        return TwinCase.all();
    }

    @ParameterizedTest
    @MethodSource("cases")
    void everyStageGivesTheBitsOfItsTwin(TwinCase twin) {
        WorldConfig config = twin.config();
        long seen = 0;
        try (OpenClStages device = new OpenClStages(openCl, config);
                HostStages host = new HostStages(config)) {
            for (int count : COUNTS) {
                int seeds = count == 1000 ? 3 : 12;
                for (int seed = 0; seed < seeds; seed++) {
                    TwinState start = TwinState.random(config, count, 1000L * seed + count);
                    device.upload(start.population(), start.velocities);
                    // enough for all: what happens when there is not is ContactOverflowTest's affair
                    device.makeRoom(20_000);
                    host.upload(start.population(), start.velocities);
                    for (int step = 0; step < STEPS; step++) {
                        seen += step(twin, device, host, start, "n = " + count + ", seed " + seed + ", step " + step);
                    }
                }
            }
        }
        assertTrue(seen > 10_000, "contacts of all worlds: " + seen);
    }

    private static int step(TwinCase twin, OpenClStages device, HostStages host, TwinState like, String where) {
        device.update();
        host.update();
        TwinState updated = compareStates(device, host, like, where + ", update");

        device.detect();
        host.detect();
        if (twin.store() == CollisionStore.COMPACT) {
            compareContacts(device, host, where + ", detect");
        }
        device.colour();
        host.colour();
        List<TwinContact> found = compareContacts(device, host, where + ", colour");
        CellGrid cells = CellGrid.of(twin.config(), like.count, like.maxRadius);
        Map<Integer, List<TwinContact>> lists = TwinContact.byOwner(found, updated, cells);
        TwinContact.checkColours(lists, cells);
        if (like.count > twin.smallWorld()) {
            float restitution = twin.config().restitution();
            assertEquals(
                    lists,
                    TwinContact.onDevice(device.contacts, found, updated, cells, restitution),
                    where + ", lists");
        }
        device.resolve();
        host.resolve();
        compareStates(device, host, like, where + ", resolve");
        assertTrue(!device.await(true).stalled(), where + " stalled");
        return found.size();
    }

    private static TwinState compareStates(Stages device, Stages host, TwinState like, String where) {
        TwinState onDevice = like.empty();
        TwinState onHost = like.empty();
        device.download(onDevice.transforms, onDevice.velocities);
        host.download(onHost.transforms, onHost.velocities);
        assertArrayEquals(onHost.bits(), onDevice.bits(), where);
        return onDevice;
    }

    /** The contacts in the device's order. */
    private static List<TwinContact> compareContacts(Stages device, Stages host, String where) {
        List<TwinContact> onDevice = TwinContact.found(device);
        List<TwinContact> onHost = TwinContact.found(host);
        assertEquals(TwinContact.sorted(onHost), TwinContact.sorted(onDevice), where);
        return onDevice;
    }
}
