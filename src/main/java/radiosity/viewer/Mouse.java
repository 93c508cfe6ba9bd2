package radiosity.viewer;

import java.awt.Component;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;

/** Looks around by dragging, walks by the wheel, asks by a click. */
final class Mouse extends MouseAdapter {

    /** A drag across the window's height turns by this, radians. */
    private static final double TURN = 1.5;
    /** A notch of the wheel walks so far, of the scene's size. */
    private static final double NOTCH = 0.02;
    /** A mouse that moves less than this between press and release clicks, pixels. */
    private static final int STILL = 3;

    private final Display display;
    private MouseEvent pressed;
    private MouseEvent last;

    Mouse(Display display) {
        this.display = display;
    }

    void listenTo(Component component) {
        component.addMouseListener(this);
        component.addMouseMotionListener(this);
        component.addMouseWheelListener(this);
    }

    @Override
    public void mousePressed(MouseEvent e) {
        e.getComponent().requestFocus();
        pressed = e;
        last = e;
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        if (last != null) {
            double radians = TURN / Math.max(1, e.getComponent().getHeight());
            display.turn((e.getX() - last.getX()) * radians, (e.getY() - last.getY()) * radians);
            last = e;
        }
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        if (pressed != null && Math.abs(e.getX() - pressed.getX()) + Math.abs(e.getY() - pressed.getY()) < STILL) {
            display.probe(e.getX(), e.getY());
        }
        pressed = null;
        last = null;
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
        display.walk(-NOTCH * e.getPreciseWheelRotation());
    }
}
