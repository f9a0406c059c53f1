package io.github.circles2d.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.github.circles2d.Circles2D;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.Snapshot;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What the scenes say of themselves, before the first step. */
class SceneTest {
    /** Scenes whose circles lie at random places, one over the other. */
    private static final Set<Scene> OVERLAPPING = Set.of(Scene.THESIS, Scene.PEBBLES);

    private static Circles2D build(Scene scene, int circles) {
        return scene.build(Circles2D.builder().device(ComputeDevice.host()), circles);
    }

    static List<Arguments> sizes() {
        List<Arguments> all = new ArrayList<>();
        for (Scene scene : Scene.ALL) {
            for (int circles : new int[] {0, 1, 2, 3, 33, 101, 3000}) {
                all.add(Arguments.of(scene.name(), circles));
            }
        }
        return all;
    }

    @ParameterizedTest
    @MethodSource("sizes")
    void allCirclesAreThereInsideAndApart(String name, int circles) {
        Scene scene = Scene.named(name);
        try (Circles2D world = build(scene, circles);
                Circles2D again = build(scene, circles)) {
            Snapshot now = world.snapshot();
            assertEquals(circles, now.count());
            assertEquals(world.stateHash(), again.stateHash(), "the same in every run");
            for (int i = 0; i < circles; i++) {
                // rounding of a coordinate near 1
                float r = now.radius(i) - 1e-7f;
                assertTrue(now.x(i) >= r && now.x(i) <= 1 - r, "x of " + i + ": " + now.x(i));
                assertTrue(now.y(i) >= r && now.y(i) <= 1 - r, "y of " + i + ": " + now.y(i));
                for (int j = 0; j < i && !OVERLAPPING.contains(scene); j++) {
                    double distance = Math.hypot(now.x(i) - now.x(j), now.y(i) - now.y(j));
                    assertTrue(distance >= (double) now.radius(i) + now.radius(j) - 2e-7, i + " and " + j + " overlap");
                }
            }
        }
    }

    @Test
    void aHundredthOfMixedIsEightTimesAsLargeAndAllCoverAThird() {
        try (Circles2D world = build(Scene.MIXED, 5000)) {
            Snapshot now = world.snapshot();
            double area = 0;
            float largest = now.radius(0) / 8;
            for (int i = 0; i < now.count(); i++) {
                area += Math.PI * now.radius(i) * now.radius(i);
                if (i < 50) {
                    assertEquals(now.radius(0), now.radius(i));
                    assertTrue(now.mass(i) >= 64 && now.mass(i) <= 640, "mass " + now.mass(i));
                } else {
                    assertTrue(now.radius(i) <= largest && now.radius(i) >= 0.659f * largest, "r " + now.radius(i));
                    assertTrue(now.mass(i) >= 1 && now.mass(i) <= 10, "mass " + now.mass(i));
                }
            }
            assertEquals(0.35, area, 0.005);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 7, 100, 101, 250, 20_000})
    void columnsAreStraightAtMostAHundredHighAndLoadedOnTop(int circles) {
        try (Circles2D column = build(Scene.COLUMN, circles);
                Circles2D loaded = build(Scene.LOADED, circles)) {
            Snapshot a = column.snapshot();
            Snapshot b = loaded.snapshot();
            int columns = 0;
            for (int i = 0; i < circles; i++) {
                boolean top = i == circles - 1 || a.x(i + 1) != a.x(i);
                columns += top ? 1 : 0;
                assertEquals(1, a.mass(i));
                assertEquals(top ? 100 : 1, b.mass(i));
                assertEquals(a.radius(0), a.radius(i));
                float below = i % 100 == 0 ? -a.radius(i) : a.y(i - 1);
                assertEquals(2 * a.radius(i), a.y(i) - below, 2e-7, "circle " + i + " touches the one below");
            }
            assertEquals((circles + 99) / 100, columns);
        }
    }

    @Test
    void bulletsFlyFortyRadiiAStepThroughAPile() {
        int circles = 1000;
        try (Circles2D pile = build(Scene.PILE, circles);
                Circles2D world = build(Scene.BULLETS, circles)) {
            Snapshot still = pile.snapshot();
            Snapshot now = world.snapshot();
            double forty = 40 * Math.sqrt(0.35 / (Math.PI * circles));
            for (int i = 0; i < circles; i++) {
                assertEquals(still.x(i), now.x(i));
                assertEquals(still.y(i), now.y(i));
                assertEquals(i % 50 == 0 ? 10 : still.mass(i), now.mass(i));
                assertEquals(i % 50 == 0 ? forty : 0, Math.hypot(now.vx(i), now.vy(i)) / 60, 1e-4 * forty);
            }
        }
    }

    @Test
    void theHelpNamesEveryScene() {
        for (Scene scene : Scene.ALL) {
            assertTrue(Options.HELP.contains(scene.name()), scene.name());
        }
    }
}
