package radiosity.viewer;

import java.awt.Color;
import java.awt.FlowLayout;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JColorChooser;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import radiosity.scene.Rgb;
import radiosity.scene.Srgb;

/** A slider and a colour for one lamp: the factor of the lamp's light is the product of both. */
final class LampControl {

    private static final int PERCENT = 100;
    /** Right end of the slider, per cent. */
    private static final int MOST = 300;

    private final String name;
    private final Consumer<Rgb> changed;
    private final JLabel label = new JLabel();
    private final JSlider slider = new JSlider(0, MOST, PERCENT);
    private final JButton button = new JButton("    ");
    private final JButton off = new JButton("off");
    private final JButton solo = new JButton("solo");
    /** Linear colour of the factor, scaled so that the largest channel is 1. */
    private Rgb colour = Rgb.grey(1);

    /**
     * @param changed receives the factor of the lamp's light, linear, per channel
     * @param alone   turns off all other lamps
     */
    LampControl(int number, String name, Consumer<Rgb> changed, Runnable alone) {
        this.name = name;
        this.changed = changed;
        slider.setName("lamp" + number);
        button.setName("colour" + number);
        slider.addChangeListener(e -> {
            label.setText(text());
            changed.accept(colour.times((double) slider.getValue() / PERCENT));
        });
        button.addActionListener(e -> choose());
        off.setName("off" + number);
        off.addActionListener(e -> changed.accept(Rgb.BLACK));
        solo.setName("solo" + number);
        solo.addActionListener(e -> alone.run());
    }

    List<JComponent> parts() {
        JPanel row = new JPanel(new FlowLayout(FlowLayout.LEFT, 2, 0));
        for (JButton one : List.of(button, solo, off)) {
            one.setFocusable(false);
            row.add(one);
        }
        row.setMaximumSize(row.getPreferredSize());
        return List.of(label, slider, row);
    }

    private String text() {
        return String.format(Locale.ROOT, "%s %d %%", name, slider.getValue());
    }

    private void choose() {
        Color chosen = JColorChooser.showDialog(button, name, button.getBackground());
        if (chosen != null) {
            colour(chosen);
        }
    }

    /** Changes the colour, in sRGB, and keeps the slider's strength. */
    void colour(Color chosen) {
        Rgb linear = new Rgb(linear(chosen.getRed()), linear(chosen.getGreen()), linear(chosen.getBlue()));
        colour = linear.max() > 0 ? linear.times(1 / linear.max()) : Rgb.grey(1);
        changed.accept(colour.times((double) slider.getValue() / PERCENT));
    }

    /** Shows the factor of the lamp's light; a factor of 0 leaves the colour as it is. */
    void show(Rgb factor) {
        if (factor.max() > 0) {
            colour = factor.times(1 / factor.max());
        }
        slider.setValue((int) Math.round(PERCENT * factor.max()));
        label.setText(text());
        button.setBackground(new Color(code(colour.r()), code(colour.g()), code(colour.b())));
    }

    private static double linear(int code) {
        return Srgb.linear(code / 255.0);
    }

    private static float code(double linear) {
        return (float) Srgb.code(Math.max(0, Math.min(1, linear)));
    }
}
