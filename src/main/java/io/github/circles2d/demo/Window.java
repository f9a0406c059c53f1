package io.github.circles2d.demo;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.io.PrintStream;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JFrame;
import javax.swing.Timer;

/** The window of the demo: controls above, circles, a status line below. */
final class Window {
    private static final int STATUS_MILLIS = 500;
    private static final int MIN_HEIGHT = 400;

    private final JFrame frame = new JFrame("Circles2D");
    private final Canvas canvas = new Canvas();
    private final StatusLine status = new StatusLine();
    private final Timer timer = new Timer(STATUS_MILLIS, event -> refresh());
    private final Simulation simulation;
    private volatile Simulation.View latest;
    private long refreshed = System.nanoTime();
    private long painted;
    private double fps;

    private Window(Setup setup, int limit) {
        simulation = new Simulation(setup, limit, this::show);
        latest = new Simulation.View(Frame.EMPTY, setup, 0, 0, 0, "", false);
        Controls controls = new Controls(simulation, setup);
        frame.add(controls, BorderLayout.NORTH);
        frame.add(canvas, BorderLayout.CENTER);
        frame.add(status, BorderLayout.SOUTH);
        frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                // gone at once; the world is closed when its step is done
                frame.setVisible(false);
                simulation.close();
            }
        });
        frame.pack();
        frame.setMinimumSize(new Dimension(controls.getPreferredSize().width + 20, MIN_HEIGHT));
        frame.setLocationByPlatform(true);
        frame.setVisible(true);
        timer.start();
    }

    /**
     * Opens the window.
     *
     * @throws java.awt.AWTError or another of AWT's failures where there is no display
     */
    static Window open(Setup setup, int limit) throws InterruptedException {
        AtomicReference<Window> window = new AtomicReference<>();
        onEventThread(() -> {
            Theme.apply();
            window.set(new Window(setup, limit));
        });
        return window.get();
    }

    JFrame frame() {
        return frame;
    }

    /** Runs the simulation in this thread until the end; false if it failed before its limit. */
    boolean run(Path picture, PrintStream out, PrintStream err) throws InterruptedException {
        try {
            boolean complete = simulation.run();
            if (complete && picture != null) {
                Pictures.save(picture(), picture);
                SimulationRun.line(out, "picture", picture.toString());
            }
            if (latest.failed()) {
                err.println(latest.message());
            } else if (!complete && picture != null) {
                err.println("closed before the picture was due");
            }
            return complete || picture == null && !latest.failed();
        } finally {
            onEventThread(() -> {
                timer.stop();
                frame.dispose();
            });
        }
    }

    private void show(Simulation.View view) {
        latest = view;
        canvas.show(view.frame());
        if (!view.message().isEmpty() || view.steps() == 0) {
            EventQueue.invokeLater(this::refresh);
        }
    }

    private void refresh() {
        Simulation.View view = latest;
        long now = System.nanoTime();
        // a slow device paints less than a frame in that time
        if (canvas.painted() > painted && now - refreshed >= STATUS_MILLIS * 1_000_000L / 2) {
            fps = (canvas.painted() - painted) * 1e9 / (now - refreshed);
            painted = canvas.painted();
            refreshed = now;
        }
        canvas.tell(view.failed() ? view.message() : "");
        status.show(view, fps);
    }

    /** The whole window but its title bar. */
    private BufferedImage picture() throws InterruptedException {
        AtomicReference<BufferedImage> picture = new AtomicReference<>();
        onEventThread(() -> {
            refresh();
            Component content = frame.getContentPane();
            BufferedImage image = Painter.picture(content.getWidth(), content.getHeight());
            content.printAll(image.getGraphics());
            picture.set(image);
        });
        return picture.get();
    }

    private static void onEventThread(Runnable task) throws InterruptedException {
        try {
            EventQueue.invokeAndWait(task);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            throw e.getCause() instanceof RuntimeException runtime ? runtime : new IllegalStateException(e.getCause());
        }
    }
}
