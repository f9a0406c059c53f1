package io.github.circles2d.demo;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JTextArea;

/** Shows a frame, and a message over it where there is one. For the event thread, save {@link #show}. */
final class Canvas extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Dimension SIZE = new Dimension(900, 740);

    private final JTextArea message = new JTextArea();
    private transient volatile Frame frame = Frame.EMPTY;
    private transient BufferedImage picture;
    private long painted;

    Canvas() {
        super(new BorderLayout());
        setPreferredSize(SIZE);
        message.setEditable(false);
        message.setLineWrap(true);
        message.setWrapStyleWord(true);
        message.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 14));
        message.setForeground(new Color(0xFFD7A8));
        message.setBackground(new Color(0x2A1D14));
        message.setBorder(BorderFactory.createEmptyBorder(12, 16, 12, 16));
        message.setVisible(false);
        add(message, BorderLayout.SOUTH);
    }

    /** Shows a frame soon. From any thread. */
    void show(Frame next) {
        frame = next;
        repaint();
    }

    /** Shows a message; none if it is empty. */
    void tell(String text) {
        if (!text.equals(message.getText())) {
            message.setText(text);
            message.setVisible(!text.isEmpty());
            revalidate();
        }
    }

    /** Frames painted so far. */
    long painted() {
        return painted;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        // in the pixels of the screen, which can be finer than those of Swing
        double scale = graphics instanceof Graphics2D g ? g.getTransform().getScaleX() : 1;
        int width = Math.max(1, (int) Math.round(getWidth() * scale));
        int height = Math.max(1, (int) Math.round(getHeight() * scale));
        if (picture == null || picture.getWidth() != width || picture.getHeight() != height) {
            picture = Painter.picture(width, height);
        }
        Painter.paint(frame, picture);
        graphics.drawImage(picture, 0, 0, getWidth(), getHeight(), null);
        painted++;
    }
}
