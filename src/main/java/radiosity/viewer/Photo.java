package radiosity.viewer;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import radiosity.output.gltf.LitScene;
import radiosity.output.image.Snapshot;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Camera;

/**
 * Draws pictures of the window's view with mirrors and glass and saves them beside the scene file, one at a time, as
 * {@code a.scene-photo-1.png} and so on.
 */
final class Photo {

    private final Optional<Path> beside;
    private final Consumer<String> messages;
    private volatile boolean isWanted = true;
    private boolean isDrawing;

    /**
     * @param beside   the scene file; empty where there is none
     * @param messages receives a line for the user, on the event thread
     */
    Photo(Optional<Path> beside, Consumer<String> messages) {
        this.beside = beside;
        this.messages = messages;
    }

    /** Begins to draw a picture on a thread of its own, unless one is being drawn; called on the event thread. */
    void take(LitScene scene, Camera camera, int width, ToneMapping toneMapping) {
        if (beside.isEmpty()) {
            messages.accept("photo: expected a scene file");
        } else if (!isDrawing) {
            isDrawing = true;
            messages.accept("drawing a photo");
            Thread drawing = new Thread(() -> draw(scene, camera, width, toneMapping), "photo");
            drawing.setDaemon(true);
            drawing.start();
        }
    }

    private void draw(LitScene scene, Camera camera, int width, ToneMapping toneMapping) {
        String line = "photo: failed";
        try {
            Path file = free();
            Snapshot.write(file, scene.solution(), camera, width, toneMapping, new Snapshot.Drawing(0,
                    done -> isWanted));
            line = "photo: " + file.getFileName();
        } catch (IOException | OutOfMemoryError e) {
            line = "photo: " + e.getMessage();
        } catch (CancellationException e) {
            line = "photo: left out";
        } finally {
            String outcome = line;
            EventQueue.invokeLater(() -> {
                isDrawing = false;
                messages.accept(outcome);
            });
        }
    }

    private Path free() {
        int number = 1;
        while (Files.exists(named(number))) {
            number++;
        }
        return named(number);
    }

    private Path named(int number) {
        return beside.get().resolveSibling(beside.get().getFileName() + "-photo-" + number + ".png");
    }

    /** Cancels the picture being drawn. */
    void close() {
        isWanted = false;
    }
}
