package radiosity.viewer;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import radiosity.output.gltf.LitScene;

/**
 * Reads a scene file again whenever a render has replaced it ({@code -si}).
 *
 * <p>A file that cannot be read is skipped: the window keeps its scene until the file is replaced again.
 */
final class FollowedFile {

    private static final int MILLISECONDS = 500;

    private final Path file;
    private final Consumer<LitScene> replaced;
    private final Timer timer = new Timer(MILLISECONDS, e -> look());
    private List<Object> seen;
    private boolean reading;

    /** @param replaced receives each new scene, on the event thread */
    FollowedFile(Path file, Consumer<LitScene> replaced) {
        this.file = file;
        this.replaced = replaced;
        seen = state();
    }

    void start() {
        timer.start();
    }

    void stop() {
        timer.stop();
    }

    private void look() {
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
        LitScene[] read = new LitScene[1];
        try {
            read[0] = LitScene.read(file);
        } catch (IOException e) {
            read[0] = null;
        }
        SwingUtilities.invokeLater(() -> {
            reading = false;
            if (read[0] != null && timer.isRunning()) {
                replaced.accept(read[0]);
            }
        });
    }
}
