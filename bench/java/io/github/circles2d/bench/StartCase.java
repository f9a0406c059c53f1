package io.github.circles2d.bench;

import io.github.circles2d.Circles2D;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** One start of {@link Start}, in a JVM of its own. */
final class StartCase {
    private StartCase() {}

    /** Takes the device's index and a file with {@link Layout#circles}: to make the circles of a scene would warm the library up. */
    public static void main(String[] args) throws IOException, ClassNotFoundException {
        long start = System.nanoTime();
        List<ComputeDevice> devices = ComputeDevice.list();
        double list = since(start);
        Circles2D.Builder builder = Circles2D.builder()
                .device(devices.get(Integer.parseInt(args[0])))
                .solver(Solver.SMALL_STEPS)
                .indexStrategy(IndexStrategy.grid())
                .substeps(8);
        start = System.nanoTime();
        float[] circles = read(Path.of(args[1]));
        double read = since(start);
        start = System.nanoTime();
        try (Circles2D world = Layout.SCENE.empty(builder, circles.length / 4)) {
            double build = since(start);
            start = System.nanoTime();
            world.addCircles(circles);
            double add = since(start);
            Child.result(list, read, build, add, step(world), step(world));
        }
    }

    private static float[] read(Path file) throws IOException, ClassNotFoundException {
        try (ObjectInputStream in = new ObjectInputStream(new BufferedInputStream(Files.newInputStream(file)))) {
            return (float[]) in.readObject();
        }
    }

    private static double step(Circles2D world) {
        long start = System.nanoTime();
        world.step();
        world.snapshot();
        return since(start);
    }

    /** Milliseconds. */
    private static double since(long start) {
        return (System.nanoTime() - start) / 1e6;
    }
}
