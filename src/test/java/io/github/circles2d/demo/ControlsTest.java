package io.github.circles2d.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import io.github.circles2d.CollisionStore;
import io.github.circles2d.ComputeDevice;
import io.github.circles2d.IndexStrategy;
import io.github.circles2d.Solver;
import java.util.Arrays;
import javax.swing.JComboBox;
import org.junit.jupiter.api.Test;

class ControlsTest {
    @Test
    void everyStrategyCanBeChosen() {
        Setup first = new Setup(
                Scene.GAS,
                50,
                Solver.SMALL_STEPS,
                0,
                IndexStrategy.auto(),
                CollisionStore.COMPACT,
                ComputeDevice.host());
        JComboBox<?> strategies = Arrays.stream(new Controls(null, first).getComponents())
                .filter(JComboBox.class::isInstance)
                .map(box -> (JComboBox<?>) box)
                .filter(box -> box.getToolTipText().equals("strategy"))
                .findFirst()
                .orElseThrow();
        assertSame(IndexStrategy.auto(), strategies.getSelectedItem());
        assertEquals(IndexStrategy.builtIn().size() + 1, strategies.getItemCount());
    }
}
