package radiosity.viewer;

import java.awt.Point;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.BufferedReader;
import java.io.File;
import java.io.InputStreamReader;
import java.nio.file.Path;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.swing.SwingUtilities;
import radiosity.output.LitScene;
import radiosity.output.ToneMapping;
import radiosity.scene.Camera;

/**
 * A window that is used as a person would, by lines on standard input; each is answered by one line.
 *
 * <p>hold KEY+KEY milliseconds; click X Y; drag X Y X Y; probe X Y; camera; exposure; shot FILE
 */
final class Session {

    private static final int SETTLE = 150;

    private final Walkthrough window;
    private final Robot robot;

    private Session(Walkthrough window) throws Exception {
        this.window = window;
        robot = new Robot();
        robot.setAutoWaitForIdle(true);
    }

    /** @param arguments scene file, width, height */
    public static void main(String[] arguments) throws Exception {
        Path file = Path.of(arguments[0]);
        Walkthrough window = Walkthrough.open(LitScene.read(file), new ViewSettings("test", false, false, Optional.empty(),
                ToneMapping.Operator.REINHARD, 0, Integer.parseInt(arguments[1]), Integer.parseInt(arguments[2]),
                Optional.of(file), Optional.empty()));
        window.screenshot();
        while (!window.canvas().hasFocus()) {
            Thread.sleep(10);
        }
        Session session = new Session(window);
        // the first key of a fresh display may only tell its window which keyboard there is
        session.hold(new String[] {"F9"}, SETTLE);
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            System.out.println(session.answer(line.split(" ")));
        }
        window.close();
        System.exit(0);
    }

    private String answer(String[] words) throws Exception {
        switch (words[0]) {
            case "hold" -> hold(words[1].split("\\+"), Integer.parseInt(words[2]));
            case "click" -> mouse(number(words, 1), number(words, 2), number(words, 1), number(words, 2));
            case "drag" -> mouse(number(words, 1), number(words, 2), number(words, 3), number(words, 4));
            case "shot" -> ImageIO.write(window.screenshot(), "png", new File(words[1]));
            default -> {
                return said(words);
            }
        }
        Thread.sleep(SETTLE);
        return "done";
    }

    private static int number(String[] words, int i) {
        return Integer.parseInt(words[i]);
    }

    private static int key(String name) throws ReflectiveOperationException {
        return KeyEvent.class.getField("VK_" + name).getInt(null);
    }

    private void hold(String[] keys, int milliseconds) throws Exception {
        for (String key : keys) {
            robot.keyPress(key(key));
        }
        Thread.sleep(milliseconds);
        for (String key : keys) {
            robot.keyRelease(key(key));
        }
    }

    private void mouse(int x0, int y0, int x1, int y1) {
        Point corner = window.canvas().getLocationOnScreen();
        robot.mouseMove(corner.x + x0, corner.y + y0);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseMove(corner.x + x1, corner.y + y1);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }

    private String said(String[] words) throws Exception {
        String[] answer = new String[1];
        SwingUtilities.invokeAndWait(() -> answer[0] = switch (words[0]) {
            case "camera" -> text(window.display().camera());
            case "exposure" -> String.valueOf(window.display().toneMapping().exposure());
            case "probe" -> window.display().probe(number(words, 1), number(words, 2)).map(Probe::lines)
                    .map(lines -> String.join("; ", lines)).orElse("nothing");
            default -> "unknown";
        });
        return answer[0];
    }

    /** Eye and direction, separated by spaces. */
    private static String text(Camera camera) {
        return camera.position().x() + " " + camera.position().y() + " " + camera.position().z() + " "
                + camera.forward().x() + " " + camera.forward().y() + " " + camera.forward().z();
    }
}
