package radiosity.viewer;

import java.awt.Component;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import radiosity.edit.Drag;

/** Listens to the mouse: a drag looks around or moves an object, the wheel walks, a click selects or probes. */
final class Mouse extends MouseAdapter {

    /** Angle by which a drag across the window's height turns the camera, radians. */
    private static final double TURN = 1.5;
    /** Distance that a notch of the wheel walks, relative to the scene's size. */
    private static final double NOTCH = 0.02;
    /** Movement between press and release below which they count as a click, pixels. */
    private static final int STILL = 3;

    private final Display display;
    private MouseEvent pressed;
    private MouseEvent last;
    private boolean holds;

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
        holds = display.editing().grab(e.getX(), e.getY());
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        if (last != null && holds) {
            Drag.Hand hand = e.isShiftDown() ? Drag.Hand.UPRIGHT : e.isControlDown() ? Drag.Hand.TURN : Drag.Hand.LEVEL;
            display.editing().drag(hand, e.getX() - last.getX(), e.getY() - last.getY());
            last = e;
        } else if (last != null) {
            double radians = TURN / Math.max(1, e.getComponent().getHeight());
            display.turn((e.getX() - last.getX()) * radians, (e.getY() - last.getY()) * radians);
            last = e;
        }
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        if (holds) {
            display.editing().drop();
        }
        if (pressed != null && Math.abs(e.getX() - pressed.getX()) + Math.abs(e.getY() - pressed.getY()) < STILL) {
            display.click(e.getX(), e.getY());
        }
        pressed = null;
        last = null;
        holds = false;
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
        display.walk(-NOTCH * e.getPreciseWheelRotation());
    }
}
