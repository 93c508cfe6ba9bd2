package radiosity.viewer;

import java.awt.Color;
import java.awt.FlowLayout;
import java.util.List;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JColorChooser;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import radiosity.scene.Rgb;
import radiosity.scene.Srgb;
import radiosity.scene.Surface;

/** The controls of editing: colour and reflectance of the selected surface, undo, save. */
final class EditPanel {

    private static final int PERCENT = 100;

    private final Editing editing;
    private final JCheckBox on = new JCheckBox("edit objects");
    private final JLabel label = new JLabel(" ");
    private final JSlider slider = new JSlider(0, (int) (PERCENT * Surface.MAX_REFLECTANCE), 0);
    private final JButton button = new JButton("    ");
    private final JButton undo = new JButton("undo");
    private final JButton save = new JButton("save");
    /** Linear colour of the surface, scaled so that the largest channel is 1. */
    private Rgb colour = Rgb.grey(1);
    private boolean refreshing;

    EditPanel(Editing editing) {
        this.editing = editing;
        on.setName("edit");
        on.addActionListener(e -> editing.toggle());
        slider.setName("reflectance");
        slider.addChangeListener(e -> {
            if (!refreshing) {
                editing.paint(colour.times((double) slider.getValue() / PERCENT), slider.getValueIsAdjusting());
            }
        });
        button.setName("paint");
        button.addActionListener(e -> choose());
        undo.setName("undo");
        undo.addActionListener(e -> editing.undo());
        save.setName("save");
        save.addActionListener(e -> editing.save());
    }

    List<JComponent> parts() {
        JPanel row = new JPanel(new FlowLayout(FlowLayout.LEFT, 2, 0));
        for (JButton one : List.of(button, undo, save)) {
            one.setFocusable(false);
            row.add(one);
        }
        row.setMaximumSize(row.getPreferredSize());
        return List.of(on, label, slider, row);
    }

    private void choose() {
        Color chosen = JColorChooser.showDialog(button, label.getText(), button.getBackground());
        if (chosen != null) {
            paint(chosen);
        }
    }

    /** Paints the surface so that it reflects a colour given in sRGB. */
    void paint(Color chosen) {
        editing.paint(new Rgb(linear(chosen.getRed()), linear(chosen.getGreen()), linear(chosen.getBlue())), false);
    }

    private static double linear(int code) {
        return Math.min(Surface.MAX_REFLECTANCE, Srgb.linear(code / 255.0));
    }

    /** Sets all controls to the present values. */
    void refresh() {
        refreshing = true;
        on.setSelected(editing.isOn());
        Surface of = editing.painted();
        for (JComponent part : List.of(slider, button)) {
            part.setEnabled(of != null && of.maps().reflectance().isEmpty());
        }
        undo.setEnabled(editing.hasBegun());
        save.setEnabled(editing.hasBegun());
        label.setText(of == null ? " " : String.format(Locale.ROOT, "%s reflects %.0f %%", of.name(),
                PERCENT * of.reflectance().max()));
        if (of != null) {
            Rgb rho = of.reflectance();
            colour = rho.max() > 0 ? rho.times(1 / rho.max()) : Rgb.grey(1);
            slider.setValue((int) Math.round(PERCENT * rho.max()));
            button.setBackground(new Color((float) Srgb.code(rho.r()), (float) Srgb.code(rho.g()),
                    (float) Srgb.code(rho.b())));
        }
        refreshing = false;
    }
}
