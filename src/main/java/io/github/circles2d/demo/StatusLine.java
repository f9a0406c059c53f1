package io.github.circles2d.demo;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;

/** What runs where and how fast, and what the colours mean. */
final class StatusLine extends JPanel {
    private static final long serialVersionUID = 1L;

    private final JLabel text = new JLabel(" ");

    StatusLine() {
        super(new BorderLayout(16, 0));
        setBorder(BorderFactory.createEmptyBorder(4, 12, 6, 12));
        JLabel legend = new JLabel("mass 1 to 10", new Ramp(), SwingConstants.RIGHT);
        legend.setHorizontalTextPosition(SwingConstants.LEFT);
        add(text, BorderLayout.CENTER);
        add(legend, BorderLayout.EAST);
    }

    void show(Simulation.View view, double fps) {
        Setup setup = view.setup();
        String where = setup.strategy().name() + "  \u00b7  " + Controls.shortName(setup.device());
        if (view.failed()) {
            text.setText("failed  \u00b7  " + where);
        } else if (!view.message().isEmpty()) {
            text.setText(view.message());
        } else {
            // what is long comes last: a narrow window cuts it
            text.setText(String.format(
                    Locale.ROOT,
                    "%.1f fps  \u00b7  %.2f ms a step  \u00b7  %,d circles  \u00b7  %,d contacts  \u00b7  %s",
                    fps,
                    view.millis(),
                    setup.circles(),
                    view.contacts(),
                    where));
        }
    }

    /** The colours from the lightest to the heaviest. */
    private static final class Ramp implements Icon {
        @Override
        public int getIconWidth() {
            return 72;
        }

        @Override
        public int getIconHeight() {
            return 10;
        }

        @Override
        public void paintIcon(Component on, Graphics graphics, int x, int y) {
            for (int k = 0; k < getIconWidth(); k++) {
                float t = k / (getIconWidth() - 1f);
                graphics.setColor(
                        new Color(Painter.colour(Painter.LIGHTEST + t * (Painter.HEAVIEST - Painter.LIGHTEST))));
                graphics.fillRect(x + k, y, 1, getIconHeight());
            }
        }
    }
}
