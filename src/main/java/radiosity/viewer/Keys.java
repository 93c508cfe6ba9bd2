package radiosity.viewer;

import java.awt.Component;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;

/** Listens to the keyboard and performs the action of each key. */
final class Keys extends KeyAdapter {

    /** Help text of key H: a key and its action per line. */
    static final String[][] HELP = {
        {"Up, Down", "walk ahead, back"},
        {"Left, Right", "turn"},
        {"Page Up, Page Down", "look up, down"},
        {"W, S, A, D", "walk ahead, back, sideways"},
        {"E, Q", "rise, sink"},
        {"Shift", "hurry"},
        {"[, ]", "slower, faster"},
        {"mouse drag, wheel", "look around, walk"},
        {"click", "radiosity and irradiance there"},
        {"Home", "back to where it began"},
        {"+, -", "brighter, darker by a third of a stop"},
        {"0", "automatic exposure"},
        {"T", "next tone mapping: linear, reinhard, filmic"},
        {"C", "luminance in colours, with a scale"},
        {"X", "wireframe"},
        {"U", "light of textures or of vertices"},
        {"K", "walk through walls or not"},
        {"M", "edit: drag objects (Shift: lift, Ctrl: turn)"},
        {"Ctrl+Z, Ctrl+S", "edit: undo, save"},
        {"F", "photo with mirrors and glass, saved"},
        {"P", "panel for the mouse: exposure, lamps"},
        {"F11", "full screen"},
        {"H", "this help"},
        {"Space", "no text"},
        {"Esc", "close"},
    };

    private static final double THIRD = 1.0 / 3;
    private static final double PACE = 1.25;

    private final Display display;
    private final Walking walking;

    Keys(Display display, Walking walking) {
        this.display = display;
        this.walking = walking;
    }

    void listenTo(Component component) {
        component.addKeyListener(this);
        component.addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent e) {
                walking.stop();
            }
        });
    }

    @Override
    public void keyPressed(KeyEvent e) {
        if (e.isControlDown() && e.getKeyCode() == KeyEvent.VK_Z) {
            display.editing().undo();
        } else if (e.isControlDown() && e.getKeyCode() == KeyEvent.VK_S) {
            display.editing().save();
        } else if (!walking.pressed(e.getKeyCode(), e.isShiftDown())) {
            act(e.getKeyCode(), e.getKeyChar());
        }
    }

    @Override
    public void keyReleased(KeyEvent e) {
        walking.released(e.getKeyCode());
    }

    private void act(int key, char typed) {
        Lighting lighting = display.lighting();
        switch (typed) {
            case '+', '=' -> display.light(() -> lighting.brighter(THIRD));
            case '-', '_' -> display.light(() -> lighting.brighter(-THIRD));
            case '0' -> display.light(() -> lighting.automaticExposure(display.camera()));
            case '[' -> walking.pace(1 / PACE);
            case ']' -> walking.pace(PACE);
            default -> act(key);
        }
    }

    private void act(int key) {
        switch (key) {
            case KeyEvent.VK_HOME -> display.home();
            case KeyEvent.VK_T -> display.light(display.lighting()::nextCurve);
            case KeyEvent.VK_C -> display.falseColour();
            case KeyEvent.VK_X -> display.wireframe();
            case KeyEvent.VK_U -> display.textures();
            case KeyEvent.VK_M -> display.editing().toggle();
            case KeyEvent.VK_F -> display.photo();
            case KeyEvent.VK_P -> display.panel();
            case KeyEvent.VK_K -> display.collisions();
            case KeyEvent.VK_F11 -> display.fullScreen();
            case KeyEvent.VK_H, KeyEvent.VK_F1 -> display.help();
            case KeyEvent.VK_SPACE -> display.quiet();
            case KeyEvent.VK_ESCAPE -> display.leave();
            default -> { }
        }
    }
}
