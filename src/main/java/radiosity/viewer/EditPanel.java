package radiosity.viewer;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import radiosity.scene.Rgb;
import radiosity.scene.Surface;

/** The controls of editing: colour and reflectance of the selected surface, undo, save. */
final class EditPanel {

    /** Right end of the slider, per cent. */
    private static final int MOST = (int) (100 * Surface.MAX_REFLECTANCE);

    private final Editing editing;
    private final JCheckBox on = new JCheckBox("edit objects");
    private final ColourControl reflectance;
    private final JButton undo;
    private final JButton save;

    EditPanel(Editing editing) {
        this.editing = editing;
        on.setName("edit");
        on.addActionListener(e -> editing.toggle());
        reflectance = new ColourControl("reflectance", "paint", MOST, true,
                (value, isMoving) -> editing.paint(possible(value), isMoving));
        undo = reflectance.button("undo", "undo", editing::undo);
        save = reflectance.button("save", "save", editing::save);
    }

    private static Rgb possible(Rgb colour) {
        return new Rgb(Math.min(Surface.MAX_REFLECTANCE, colour.r()), Math.min(Surface.MAX_REFLECTANCE, colour.g()),
                Math.min(Surface.MAX_REFLECTANCE, colour.b()));
    }

    List<JComponent> parts() {
        List<JComponent> parts = new ArrayList<>(List.of(on));
        parts.addAll(reflectance.parts());
        return parts;
    }

    /** Colour that the selected surface reflects. */
    ColourControl reflectance() {
        return reflectance;
    }

    /** Sets all controls to the present values. */
    void refresh() {
        on.setSelected(editing.isOn());
        undo.setEnabled(editing.hasBegun());
        save.setEnabled(editing.hasBegun());
        Surface of = editing.painted();
        reflectance.enable(of != null && of.maps().reflectance().isEmpty());
        if (of == null) {
            reflectance.clear();
        } else {
            reflectance.show(of.name() + " reflects", of.reflectance());
        }
    }
}
