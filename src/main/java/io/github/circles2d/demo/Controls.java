package io.github.circles2d.demo;

import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import java.awt.FlowLayout;
import java.util.List;
import java.util.Locale;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;

/** The buttons and choices above the circles; they tell the simulation and nobody else. */
final class Controls extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int NAME_LENGTH = 24;

    /** The thesis' sizes, and smaller ones. */
    private static final List<Integer> SIZES = List.of(100, 500, 1250, 2500, 5000, 10000, 15000);

    private final transient Simulation simulation;
    private final transient Setup first;
    private final JToggleButton pause = new JToggleButton("Pause");
    private final JButton step = new JButton("Step");
    private final JButton restart = new JButton("Restart");
    private final JComboBox<Scene> scenes;
    private final JComboBox<Integer> sizes;
    private final JComboBox<Solver> solvers;
    private final JComboBox<IndexStrategy> strategies;
    private final JComboBox<ComputeDevice> devices;

    Controls(Simulation simulation, Setup first) {
        super(new FlowLayout(FlowLayout.LEFT, 4, 4));
        this.simulation = simulation;
        this.first = first;
        setBorder(BorderFactory.createEmptyBorder(4, 8, 0, 8));
        TreeSet<Integer> offered = new TreeSet<>(SIZES);
        offered.add(first.circles());
        add(pause);
        add(step);
        add(restart);
        scenes = choice("scene", Scene.ALL, first.scene(), Scene::name);
        sizes = choice("circles", List.copyOf(offered), first.circles(), n -> String.format(Locale.ROOT, "%,d", n));
        solvers = choice(
                "solver",
                List.of(Solver.values()),
                first.solver(),
                solver -> solver.name().toLowerCase(Locale.ROOT));
        strategies = choice(
                "strategy",
                Stream.concat(IndexStrategy.builtIn().stream(), Stream.of(IndexStrategy.auto()))
                        .toList(),
                first.strategy(),
                IndexStrategy::name);
        devices = choice("device", ComputeDevice.list(), first.device(), Controls::shortName);
        step.setEnabled(false);
        pause.addActionListener(event -> pause(pause.isSelected()));
        step.addActionListener(event -> simulation.single());
        restart.addActionListener(event -> restart());
    }

    private void pause(boolean paused) {
        pause.setText(paused ? "Resume" : "Pause");
        step.setEnabled(paused);
        simulation.pause(paused);
    }

    private void restart() {
        simulation.restart(new Setup(
                (Scene) scenes.getSelectedItem(),
                (Integer) sizes.getSelectedItem(),
                (Solver) solvers.getSelectedItem(),
                first.substeps(),
                (IndexStrategy) strategies.getSelectedItem(),
                first.store(),
                (ComputeDevice) devices.getSelectedItem()));
    }

    private <T> JComboBox<T> choice(String label, List<T> items, T selected, Function<? super T, String> text) {
        JComboBox<T> box = new JComboBox<>();
        items.forEach(box::addItem);
        box.setSelectedItem(selected);
        box.setToolTipText(label);
        DefaultListCellRenderer cell = new DefaultListCellRenderer();
        box.setRenderer((list, item, index, chosen, focus) ->
                cell.getListCellRendererComponent(list, text.apply(item), index, chosen, focus));
        box.addActionListener(event -> restart());
        add(new JLabel("  " + label));
        add(box);
        return box;
    }

    /** A device in a few words. */
    static String shortName(ComputeDevice device) {
        String name = device.name();
        String part = name.length() <= NAME_LENGTH ? name : name.substring(0, NAME_LENGTH - 1) + "\u2026";
        return device.type() == ComputeDevice.Type.HOST ? "plain Java" : part + " (" + device.type() + ")";
    }
}
