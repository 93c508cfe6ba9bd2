package radiosity.viewer;

import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.KeyboardFocusManager;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.File;
import java.io.InputStreamReader;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.swing.AbstractButton;
import javax.swing.JSlider;
import javax.swing.SwingUtilities;
import radiosity.cli.render.SceneSource;
import radiosity.output.gltf.LitScene;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Camera;

/**
 * A window that is used by lines on standard input; each is answered by one line.
 *
 * <p>hold KEY+KEY milliseconds; tell KEY+KEY (answered by the status, before anything else happens); click X Y; drag
 * X Y X Y [KEY]; mouse PRESSED|DRAGGED|RELEASED X Y; probe X Y; paint RED GREEN BLUE; status; camera; exposure; shot
 * FILE; screen FILE; real KEY; press BUTTON; set SLIDER NUMBER; colour LAMP RED GREEN BLUE
 *
 * <p>Keys and mouse are events given to the canvas, and time is a counter: however busy the machine is, a key is held
 * for as long as it says. Only {@code real} presses a key of the display, until the window has walked.
 */
final class Session {

    private static final long STEP = Walking.FRAME_MILLISECONDS * 1_000_000L;
    /** A key of the display that has done nothing after so many looks is pressed again. */
    private static final int LOOKS = 100;
    private static final int MOST_PRESSES = 60;
    private static final int LOOK_MILLISECONDS = 10;

    private final Walkthrough window;
    private volatile long nanoseconds;

    private Session(Walkthrough window) throws Exception {
        this.window = window;
        onEventThread(() -> {
            window.display().walking().clock(() -> nanoseconds);
            return null;
        });
    }

    /** @param arguments scene file, width, height */
    public static void main(String[] arguments) {
        try {
            run(arguments);
            System.exit(0);
        } catch (Exception e) {
            e.printStackTrace();
            System.exit(1);
        }
    }

    private static void run(String[] arguments) throws Exception {
        Path file = Path.of(arguments[0]);
        Walkthrough window = Walkthrough.open(LitScene.read(file),
                new ViewSettings("test", false, false, Optional.empty(),
                ToneMapping.Operator.REINHARD, 0, Integer.parseInt(arguments[1]), Integer.parseInt(arguments[2]),
                Optional.of(file), Optional.of(() -> SceneSource.read(file, Optional.empty(), line -> { })),
                Optional.empty()));
        window.screenshot();
        Session session = new Session(window);
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            System.out.println(session.answer(line.split(" ")));
        }
        window.close();
    }

    private static <T> T onEventThread(Callable<T> task) throws Exception {
        FutureTask<T> future = new FutureTask<>(task);
        SwingUtilities.invokeAndWait(future);
        return future.get();
    }

    private String answer(String[] words) throws Exception {
        return switch (words[0]) {
            case "shot" -> String.valueOf(ImageIO.write(window.screenshot(), "png", new File(words[1])));
            case "screen" -> String.valueOf(ImageIO.write(screen(), "png", new File(words[1])));
            case "real" -> real(key(words[1]));
            default -> onEventThread(() -> said(words));
        };
    }

    private String said(String[] words) throws ReflectiveOperationException {
        switch (words[0]) {
            case "hold" -> hold(words[1].split("\\+"), number(words, 2));
            case "tell" -> {
                hold(words[1].split("\\+"), 0);
                return String.join("; ", window.display().status());
            }
            case "click" -> mouse(number(words, 1), number(words, 2), number(words, 1), number(words, 2), "");
            case "drag" -> mouse(number(words, 1), number(words, 2), number(words, 3), number(words, 4),
                    words.length > 5 ? words[5] : "");
            case "mouse" -> move(MouseEvent.class.getField("MOUSE_" + words[1]).getInt(null), number(words, 2),
                    number(words, 3), "");
            case "paint" -> window.panel().edit().reflectance()
                    .choose(new Color(number(words, 1), number(words, 2), number(words, 3)));
            case "status" -> {
                return String.join("; ", window.display().status());
            }
            case "press" -> part(words[1], AbstractButton.class).doClick(0);
            case "set" -> part(words[1], JSlider.class).setValue(number(words, 2));
            case "colour" -> window.panel().lamp(number(words, 1))
                    .choose(new Color(number(words, 2), number(words, 3), number(words, 4)));
            case "size" -> {
                return window.canvas().getWidth() + " " + window.canvas().getHeight();
            }
            case "camera" -> {
                return text(window.display().camera());
            }
            case "exposure" -> {
                return String.valueOf(window.display().lighting().toneMapping().exposure());
            }
            case "probe" -> {
                return window.display().probe(number(words, 1), number(words, 2)).map(Probe::lines)
                        .map(lines -> String.join("; ", lines)).orElse("nothing");
            }
            default -> {
                return "unknown";
            }
        }
        return "done";
    }

    /** A component of the panel. */
    private <T extends Component> T part(String name, Class<T> type) {
        return type.cast(find(window.panel().component(), name).orElseThrow());
    }

    private static Optional<Component> find(Component in, String name) {
        if (name.equals(in.getName())) {
            return Optional.of(in);
        }
        return in instanceof Container container ? Stream.of(container.getComponents())
                .flatMap(part -> find(part, name).stream()).findFirst() : Optional.empty();
    }

    /** All of the window, as the display shows it. */
    private BufferedImage screen() throws Exception {
        window.screenshot();
        Robot robot = new Robot();
        robot.waitForIdle();
        return robot.createScreenCapture(SwingUtilities.getWindowAncestor(window.canvas()).getBounds());
    }

    private static int number(String[] words, int i) {
        return Integer.parseInt(words[i]);
    }

    private static int key(String name) throws ReflectiveOperationException {
        return KeyEvent.class.getField("VK_" + name).getInt(null);
    }

    /** Presses keys, lets so much time go by in steps, and releases them. */
    private void hold(String[] keys, int milliseconds) throws ReflectiveOperationException {
        int modifiers = modifiers(List.of(keys));
        for (String key : keys) {
            give(KeyEvent.KEY_PRESSED, key(key), modifiers);
        }
        pass(milliseconds * 1_000_000L);
        for (String key : keys) {
            give(KeyEvent.KEY_RELEASED, key(key), modifiers);
        }
        window.display().walking().stop();
    }

    private void pass(long time) {
        for (long end = nanoseconds + time; nanoseconds < end;) {
            nanoseconds += STEP;
            window.display().walking().tick();
        }
    }

    /** Straight to the canvas: whether the window has the focus makes no difference. */
    private void give(int id, int key, int modifiers) {
        char typed = key < 128 ? Character.toLowerCase((char) key) : KeyEvent.CHAR_UNDEFINED;
        KeyboardFocusManager.getCurrentKeyboardFocusManager().redispatchEvent(window.canvas(),
                new KeyEvent(window.canvas(), id, 0, modifiers, key, typed));
    }

    private static int modifiers(List<String> keys) {
        return (keys.contains("SHIFT") ? InputEvent.SHIFT_DOWN_MASK : 0)
                + (keys.contains("CONTROL") ? InputEvent.CTRL_DOWN_MASK : 0);
    }

    private void mouse(int x0, int y0, int x1, int y1, String key) {
        move(MouseEvent.MOUSE_PRESSED, x0, y0, key);
        if (x0 != x1 || y0 != y1) {
            move(MouseEvent.MOUSE_DRAGGED, (x0 + x1) / 2, (y0 + y1) / 2, key);
            move(MouseEvent.MOUSE_DRAGGED, x1, y1, key);
        }
        move(MouseEvent.MOUSE_RELEASED, x1, y1, key);
    }

    private void move(int id, int x, int y, String key) {
        window.canvas().dispatchEvent(new MouseEvent(window.canvas(), id, 0,
                InputEvent.BUTTON1_DOWN_MASK + modifiers(List.of(key)), x, y, 1, false, MouseEvent.BUTTON1));
    }

    /**
     * Holds a key of the display until the window has walked a step: the first key of a fresh display may only tell its
     * window which keyboard there is.
     */
    private String real(int key) throws Exception {
        Robot robot = new Robot();
        String before = onEventThread(() -> text(window.display().camera()));
        for (int press = 0; press < MOST_PRESSES; press++) {
            robot.keyPress(key);
            boolean walked = walks(before);
            robot.keyRelease(key);
            if (walked) {
                return "walked";
            }
        }
        return "stands";
    }

    private boolean walks(String before) throws Exception {
        for (int look = 0; look < LOOKS; look++) {
            nanoseconds += STEP;
            if (!onEventThread(() -> text(window.display().camera())).equals(before)) {
                return true;
            }
            Thread.sleep(LOOK_MILLISECONDS);
        }
        return false;
    }

    /** Eye and direction, separated by spaces. */
    private static String text(Camera camera) {
        return camera.position().x() + " " + camera.position().y() + " " + camera.position().z() + " "
                + camera.forward().x() + " " + camera.forward().y() + " " + camera.forward().z();
    }
}
