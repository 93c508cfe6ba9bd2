package radiosity.viewer;

import java.awt.Color;
import java.awt.FlowLayout;
import java.util.List;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JColorChooser;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import radiosity.scene.Rgb;
import radiosity.scene.Srgb;

/** A slider in per cent and a button for a colour: the value that they set is the product of both. */
final class ColourControl {

    private static final int PERCENT = 100;

    private final boolean isWhole;
    private final Listener listener;
    private final JLabel label = new JLabel(" ");
    private final JSlider slider;
    private final JPanel row = new JPanel(new FlowLayout(FlowLayout.LEFT, 2, 0));
    private final JButton button;
    /** Linear colour of the value, scaled so that the largest channel is 1. */
    private Rgb colour = Rgb.grey(1);
    private boolean isShowing;

    /** Receives a value that the user has set, linear, per channel. */
    interface Listener {
        /** @param isMoving whether the user is still dragging the slider */
        void set(Rgb value, boolean isMoving);
    }

    /**
     * @param most    right end of the slider, per cent
     * @param isWhole whether a chosen colour is the value; else the slider's strength is kept
     */
    ColourControl(String sliderName, String colourName, int most, boolean isWhole, Listener listener) {
        this.isWhole = isWhole;
        this.listener = listener;
        slider = new JSlider(0, most, 0);
        slider.setName(sliderName);
        slider.addChangeListener(e -> {
            if (!isShowing) {
                listener.set(strong(colour), slider.getValueIsAdjusting());
            }
        });
        button = button(colourName, "    ", this::choose);
    }

    /** Adds a button to the row below the slider. */
    JButton button(String name, String text, Runnable action) {
        JButton added = ControlPanel.button(name, text, action);
        added.setFocusable(false);
        row.add(added);
        return added;
    }

    List<JComponent> parts() {
        row.setMaximumSize(row.getPreferredSize());
        return List.of(label, slider, row);
    }

    private Rgb strong(Rgb scaled) {
        return scaled.times((double) slider.getValue() / PERCENT);
    }

    private static Rgb scaled(Rgb value, Rgb ofBlack) {
        return value.max() > 0 ? value.times(1 / value.max()) : ofBlack;
    }

    private void choose() {
        Color chosen = JColorChooser.showDialog(button, label.getText(), button.getBackground());
        if (chosen != null) {
            choose(chosen);
        }
    }

    /** Sets a colour given in sRGB. */
    void choose(Color chosen) {
        Rgb linear = new Rgb(linear(chosen.getRed()), linear(chosen.getGreen()), linear(chosen.getBlue()));
        listener.set(isWhole ? linear : strong(scaled(linear, Rgb.grey(1))), false);
    }

    /** Shows a value; the value 0 leaves the colour as it is, unless a chosen colour is the value. */
    void show(String name, Rgb value) {
        isShowing = true;
        label.setText(String.format(Locale.ROOT, "%s %.0f %%", name, PERCENT * value.max()));
        colour = scaled(value, isWhole ? Rgb.grey(1) : colour);
        slider.setValue((int) Math.round(PERCENT * value.max()));
        Rgb seen = isWhole ? value : colour;
        button.setBackground(new Color(code(seen.r()), code(seen.g()), code(seen.b())));
        isShowing = false;
    }

    /** Shows no value. */
    void clear() {
        label.setText(" ");
    }

    void enable(boolean isEnabled) {
        slider.setEnabled(isEnabled);
        button.setEnabled(isEnabled);
    }

    private static double linear(int code) {
        return Srgb.linear(code / 255.0);
    }

    private static float code(double linear) {
        return (float) Srgb.code(Math.max(0, Math.min(1, linear)));
    }
}
