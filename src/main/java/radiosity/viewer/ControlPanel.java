package radiosity.viewer;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import javax.swing.JScrollPane;
import javax.swing.JSlider;
import radiosity.output.gltf.LampMix;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Rgb;

/**
 * A panel beside the picture that does with the mouse what keys do, with a slider and a colour for each lamp and for
 * the edited surface. All methods are called on the event thread.
 *
 * <p>No component takes the keyboard focus from the picture. Components have names, by which tests find them.
 */
final class ControlPanel {

    private static final int WIDTH = 280;
    private static final int EDGE = 8;
    /** Steps of the exposure slider per EV, and largest exposure in EV, up or down. */
    private static final int STEPS = 3;
    private static final int MOST_STOPS = 10;
    /** Right end of the slider of a lamp, per cent. */
    private static final int MOST_LAMP = 300;

    private final Display display;
    private final JPanel content = new JPanel();
    private final JScrollPane scroll = new JScrollPane(content, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED,
            JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
    private final JLabel exposure = new JLabel();
    private final JSlider stops = new JSlider(-STEPS * MOST_STOPS, STEPS * MOST_STOPS, 0);
    private final List<AbstractButton> curves = new ArrayList<>();
    private final JCheckBox falseColour = new JCheckBox("luminance in colours");
    private final JCheckBox wireframe = new JCheckBox("wireframe");
    private final JCheckBox textures = new JCheckBox("light of textures");
    private final JCheckBox walls = new JCheckBox("walls stop you");
    private final EditPanel edit;
    private final JPanel lamps = new JPanel();
    private final List<ColourControl> lampControls = new ArrayList<>();
    private List<String> shown = List.of();
    /** Whether components are being set to the present values: changes then do not act on the display. */
    private boolean refreshing;

    ControlPanel(Display display) {
        this.display = display;
        edit = new EditPanel(display.editing());
        content.setLayout(new BoxLayout(content, BoxLayout.Y_AXIS));
        content.setBorder(BorderFactory.createEmptyBorder(EDGE, EDGE, EDGE, EDGE));
        lamps.setLayout(new BoxLayout(lamps, BoxLayout.Y_AXIS));
        addLight();
        check(falseColour, "falseColour", display::falseColour);
        check(wireframe, "wireframe", display::wireframe);
        check(textures, "textures", display::textures);
        check(walls, "walls", display::collisions);
        edit.parts().forEach(part -> add(content, part));
        add(content, lamps);
        content.add(Box.createVerticalGlue());
        // the layout makes the panel as high as the picture
        scroll.setPreferredSize(new Dimension(WIDTH, 1));
        scroll.setVisible(false);
        refresh();
    }

    private void addLight() {
        Lighting lighting = display.lighting();
        add(content, exposure);
        stops.setName("stops");
        stops.addChangeListener(e -> act(() -> display.light(() -> lighting.stops((double) stops.getValue() / STEPS))));
        add(content, stops);
        add(content, button("automatic", "automatic exposure",
                () -> display.light(() -> lighting.automaticExposure(display.camera()))));
        ButtonGroup group = new ButtonGroup();
        for (ToneMapping.Operator curve : ToneMapping.Operator.values()) {
            String name = curve.name().toLowerCase(Locale.ROOT);
            JRadioButton choice = new JRadioButton(name);
            choice.setName(name);
            choice.addActionListener(e -> display.light(() -> lighting.curve(curve)));
            group.add(choice);
            curves.add(choice);
            add(content, choice);
        }
    }

    private void check(JCheckBox box, String name, Runnable toggle) {
        box.setName(name);
        box.addActionListener(e -> toggle.run());
        add(content, box);
    }

    static JButton button(String name, String text, Runnable action) {
        JButton button = new JButton(text);
        button.setName(name);
        button.addActionListener(e -> action.run());
        return button;
    }

    private static void add(JPanel to, JComponent component) {
        component.setFocusable(false);
        component.setAlignmentX(Component.LEFT_ALIGNMENT);
        to.add(component);
    }

    private void act(Runnable action) {
        if (!refreshing) {
            action.run();
        }
    }

    /** The component to be put into the window. */
    JComponent component() {
        return scroll;
    }

    EditPanel edit() {
        return edit;
    }

    ColourControl lamp(int lamp) {
        return lampControls.get(lamp);
    }

    /** Sets all components to the present values. */
    void refresh() {
        refreshing = true;
        Lighting lighting = display.lighting();
        exposure.setText(String.format(Locale.ROOT, "exposure %+.2f EV", lighting.stops()));
        stops.setValue((int) Math.round(STEPS * lighting.stops()));
        curves.get(lighting.toneMapping().operator().ordinal()).setSelected(true);
        falseColour.setSelected(lighting.falseColour());
        wireframe.setSelected(display.showsWireframe());
        textures.setSelected(display.showsTextures());
        textures.setEnabled(lighting.scene().textures().isPresent());
        walls.setSelected(display.collides());
        edit.refresh();
        if (!shown.equals(lighting.mix().groups())) {
            shown = lighting.mix().groups();
            replaceLamps();
        }
        for (int lamp = 0; lamp < lampControls.size(); lamp++) {
            lampControls.get(lamp).show(shown.get(lamp), lighting.mix().factor(lamp));
        }
        refreshing = false;
    }

    private void replaceLamps() {
        lamps.removeAll();
        lampControls.clear();
        for (int i = 0; i < shown.size(); i++) {
            int lamp = i;
            ColourControl control = new ColourControl("lamp" + i, "colour" + i, MOST_LAMP, false,
                    (factor, isMoving) -> display.lamp(lamp, factor));
            control.button("solo" + i, "solo", () -> display.mix(display.lighting().mix().only(lamp)));
            control.button("off" + i, "off", () -> display.lamp(lamp, Rgb.BLACK));
            lampControls.add(control);
            control.parts().forEach(part -> add(lamps, part));
        }
        if (!shown.isEmpty()) {
            add(lamps, button("asRendered", "lamps as rendered",
                    () -> display.mix(LampMix.asRendered(display.lighting().mix().lamps()))));
            JPanel mix = new JPanel(new FlowLayout(FlowLayout.LEFT, 0, 0));
            add(mix, button("saveMix", "save mix", display::saveMix));
            add(mix, button("loadMix", "load mix", display::loadMix));
            mix.setMaximumSize(mix.getPreferredSize());
            add(lamps, mix);
        }
        lamps.revalidate();
    }
}
