package io.github.circles2d.demo;

import java.awt.Color;
import javax.swing.UIManager;
import javax.swing.plaf.nimbus.NimbusLookAndFeel;

/** Dark controls, as the box is dark. */
final class Theme {
    private Theme() {}

    static void apply() {
        try {
            UIManager.put("control", new Color(0x14191F));
            UIManager.put("info", new Color(0x232B33));
            UIManager.put("nimbusBase", new Color(0x101820));
            UIManager.put("nimbusBlueGrey", new Color(0x2A343E));
            UIManager.put("nimbusLightBackground", new Color(0x1B222A));
            UIManager.put("nimbusFocus", new Color(0x38B2A8));
            UIManager.put("nimbusSelectionBackground", new Color(0x1C7A80));
            UIManager.put("nimbusSelectedText", new Color(0xFFFFFF));
            UIManager.put("nimbusDisabledText", new Color(0x66727E));
            UIManager.put("text", new Color(0xC9D3DC));
            UIManager.setLookAndFeel(new NimbusLookAndFeel());
        } catch (javax.swing.UnsupportedLookAndFeelException e) {
            // the controls work in any look
            System.getLogger("io.github.circles2d").log(System.Logger.Level.DEBUG, "no dark controls", e);
        }
    }
}
