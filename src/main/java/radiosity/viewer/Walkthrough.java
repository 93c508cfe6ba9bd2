package radiosity.viewer;

import com.formdev.flatlaf.FlatDarkLaf;
import java.awt.AWTError;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Frame;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import radiosity.output.file.AtomicFile;
import radiosity.output.gltf.LitScene;
import radiosity.output.image.PictureFormat;

/** A window in which the user walks through a scene (appendix C.4 of the paper). */
public final class Walkthrough {

    private static final long PATIENCE_SECONDS = 60;

    private final Stage stage = new Stage();
    private final Frame frame;
    private final Display display;
    private final ControlPanel panel;
    private final Optional<FollowedFile> followed;
    private final CountDownLatch closed = new CountDownLatch(1);

    /** Makes the window; called on the event thread. */
    private Walkthrough(LitScene scene, ViewSettings settings) {
        frame = new Frame(settings.title(), stage.canvas().getGraphicsConfiguration());
        frame.setLayout(new BorderLayout());
        frame.add(stage.canvas(), BorderLayout.CENTER);
        int height = settings.height() > 0 ? settings.height()
                : Math.max(1, (int) Math.round(settings.width() / scene.camera().aspect()));
        stage.canvas().setPreferredSize(new Dimension(settings.width(), height));
        display = new Display(stage, scene, settings, controls());
        panel = new ControlPanel(display);
        display.whenChanged(panel::refresh);
        frame.add(panel.component(), BorderLayout.EAST);
        followed = settings.followed().map(file -> new FollowedFile(file, () -> LitScene.read(file), other -> {
            if (!display.editing().hasBegun()) {
                display.replace(other);
            }
        }, line -> display.status(List.of(line))));
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                display.leave();
            }
        });
        stage.canvas().addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                display.resized();
            }
        });
    }

    private Display.WindowControls controls() {
        return new Display.WindowControls() {
            @Override
            public void fullScreen() {
                GraphicsDevice screen = frame.getGraphicsConfiguration().getDevice();
                screen.setFullScreenWindow(screen.getFullScreenWindow() == frame ? null : frame);
            }

            @Override
            public void panel() {
                panel.component().setVisible(!panel.component().isVisible());
                frame.validate();
            }

            @Override
            public void close() {
                Walkthrough.this.close();
            }
        };
    }

    /**
     * Opens a window and returns when it is closed or, where a screenshot is asked for, when the screenshot is written.
     *
     * @throws DisplayException where there is no display, or one without OpenGL 2
     * @throws IOException where a texture cannot be read or the screenshot cannot be written
     */
    public static void show(LitScene scene, ViewSettings settings) throws DisplayException, IOException {
        Walkthrough walkthrough = open(scene, settings);
        try {
            if (settings.screenshot().isPresent()) {
                write(walkthrough.screenshot(), settings.screenshot().get());
            } else {
                walkthrough.closed.await();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            walkthrough.close();
        }
    }

    /** Writes a picture; an exception names the file, which the message of a full disk does not. */
    private static void write(BufferedImage image, Path file) throws IOException {
        byte[] png = PictureFormat.png(image);
        try {
            AtomicFile.write(file, png);
        } catch (FileSystemException e) {
            throw e;
        } catch (IOException e) {
            FileSystemException named = new FileSystemException(file.toString(), null, e.getMessage());
            named.initCause(e);
            throw named;
        }
    }

    public static Walkthrough open(LitScene scene, ViewSettings settings) throws DisplayException, IOException {
        try {
            if (GraphicsEnvironment.isHeadless()) {
                throw new DisplayException(noDisplay("none"), null);
            }
            AtomicReference<Walkthrough> opened = new AtomicReference<>();
            SwingUtilities.invokeAndWait(() -> {
                FlatDarkLaf.setup();
                opened.set(new Walkthrough(scene, settings));
                opened.get().start();
            });
            return opened.get();
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof UncheckedIOException unreadable) {
                throw unreadable.getCause();
            }
            throw new DisplayException(noDisplay(String.valueOf(e.getCause())), e);
        } catch (AWTError | UnsatisfiedLinkError | NoClassDefFoundError e) {
            throw new DisplayException(noDisplay(e.getMessage()), e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new DisplayException("window: expected to be opened, got an interruption", e);
        }
    }

    private static String noDisplay(String got) {
        return "display: expected one with OpenGL 2 or later (on a host without: xvfb-run scripts/ViewSceneFile ...,"
                + " or RadiosityRenderer --picture), got " + got;
    }

    private void start() {
        frame.pack();
        frame.setVisible(true);
        stage.canvas().requestFocus();
        display.look();
        followed.ifPresent(FollowedFile::start);
    }

    public SceneCanvas canvas() {
        return stage.canvas();
    }

    public Display display() {
        return display;
    }

    ControlPanel panel() {
        return panel;
    }

    /** Returns a picture that shows every change made before the call. */
    public BufferedImage screenshot() throws DisplayException, InterruptedException {
        frames(2);
        return frames(1);
    }

    /** Waits for a number of pictures; returns the last. */
    private BufferedImage frames(int count) throws DisplayException, InterruptedException {
        BufferedImage last = null;
        for (int i = 0; i < count; i++) {
            CompletableFuture<BufferedImage> next = stage.canvas().next();
            Timer redraw = new Timer(Walking.FRAME_MILLISECONDS, e -> stage.redraw());
            redraw.start();
            try {
                last = next.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
            } catch (ExecutionException | TimeoutException e) {
                throw new DisplayException("window: expected a picture within " + PATIENCE_SECONDS
                        + " s, got none", e);
            } finally {
                redraw.stop();
            }
        }
        return last;
    }

    public void close() {
        SwingUtilities.invokeLater(() -> {
            if (closed.getCount() > 0) {
                followed.ifPresent(FollowedFile::stop);
                display.close();
                stage.close();
                frame.dispose();
                closed.countDown();
            }
        });
    }
}
