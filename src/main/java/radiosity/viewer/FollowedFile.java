package radiosity.viewer;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import radiosity.output.gltf.LitScene;

/**
 * Reads a scene file again whenever a render has replaced it ({@code -si}).
 *
 * <p>A file that cannot be read is skipped: the user gets a line, and the window keeps its scene until the file is
 * replaced again.
 */
final class FollowedFile {

    private static final int MILLISECONDS = 500;

    private final Path file;
    private final Callable<LitScene> reader;
    private final Consumer<LitScene> replaced;
    private final Consumer<String> failed;
    private final Timer timer = new Timer(MILLISECONDS, e -> poll());
    private List<Object> seen;
    private boolean reading;

    /**
     * @param reader   reads the file, on a thread of its own
     * @param replaced receives each new scene, on the event thread
     * @param failed   receives a line for the user where a new scene cannot be read, on the event thread
     */
    FollowedFile(Path file, Callable<LitScene> reader, Consumer<LitScene> replaced, Consumer<String> failed) {
        this.file = file;
        this.reader = reader;
        this.replaced = replaced;
        this.failed = failed;
        seen = state();
    }

    void start() {
        timer.start();
    }

    void stop() {
        timer.stop();
    }

    private void poll() {
        List<Object> now = state();
        if (!reading && !now.isEmpty() && !now.equals(seen)) {
            seen = now;
            reading = true;
            new Thread(this::read, "scene file").start();
        }
    }

    /** Returns a value that differs when the file has been replaced; empty where there is no file. */
    private List<Object> state() {
        try {
            BasicFileAttributes a = Files.readAttributes(file, BasicFileAttributes.class);
            return List.of(a.lastModifiedTime(), a.size(), String.valueOf(a.fileKey()));
        } catch (IOException e) {
            return List.of();
        }
    }

    private void read() {
        try {
            LitScene read = reader.call();
            SwingUtilities.invokeLater(() -> end(() -> replaced.accept(read)));
        } catch (Exception | OutOfMemoryError e) {
            SwingUtilities.invokeLater(() -> end(() -> failed.accept("not read again: " + Editing.reason(e))));
        }
    }

    private void end(Runnable outcome) {
        reading = false;
        if (timer.isRunning()) {
            outcome.run();
        }
    }
}
