package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.function.Predicate;
import java.util.stream.Stream;
import radiosity.testkit.Xvfb;

/** A window on a display in memory, in a process of its own, that does what it is told: see {@link Session}. */
final class DrivenWindow implements AutoCloseable {

    private static final int LOOKS = 200;

    private final Xvfb display = new Xvfb();
    private final Process process;
    private final PrintWriter to;
    private final BufferedReader from;
    private final Path folder;

    /** @param folder for pictures */
    DrivenWindow(Path scene, Path folder) throws IOException {
        this(scene, folder, Rendered.SIZE, Rendered.SIZE);
    }

    DrivenWindow(Path scene, Path folder, int width, int height) throws IOException {
        this.folder = folder;
        process = display.program(Session.class, scene.toString(), "" + width, "" + height)
                .redirectError(ProcessBuilder.Redirect.DISCARD).start();
        to = new PrintWriter(process.getOutputStream(), true);
        from = new BufferedReader(new InputStreamReader(process.getInputStream()));
    }

    String say(String line) throws IOException {
        to.println(line);
        String answer = from.readLine();
        assertNotNull(answer, "the window went away at: " + line);
        return answer;
    }

    void tap(String key) throws IOException {
        say("hold " + key + " 40");
    }

    BufferedImage shot(String name) throws IOException {
        Path file = folder.resolve(name + ".png");
        say("shot " + file);
        return Rendered.picture(file);
    }

    /** All of the window, with its panel. */
    BufferedImage screen(String name) throws IOException {
        Path file = folder.resolve(name + ".png");
        say("screen " + file);
        return Rendered.picture(file);
    }

    /** Eye and direction. */
    double[] camera() throws IOException {
        return Stream.of(say("camera").split(" ")).mapToDouble(Double::parseDouble).toArray();
    }

    /** What a click tells under a name: three numbers. */
    double[] probe(int x, int y, String name) throws IOException {
        return numbers(say("probe " + x + " " + y), name);
    }

    static double[] numbers(String lines, String name) {
        String line = Stream.of(lines.split("; ")).filter(l -> l.startsWith(name)).findFirst().orElseThrow();
        return Stream.of(line.substring(name.length()).replaceAll("W/m²|lm/m²|lx", "").trim().split(" +"))
                .mapToDouble(Double::parseDouble).toArray();
    }

    /** Whether the picture, without text, does so within some time. */
    boolean becomes(Predicate<BufferedImage> wanted) throws Exception {
        for (int i = 0; i < LOOKS; i++) {
            tap("SPACE");
            if (wanted.test(shot("now"))) {
                return true;
            }
            Thread.sleep(100);
        }
        return false;
    }

    @Override
    public void close() {
        process.destroy();
        display.close();
    }
}
