package radiosity.viewer;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import radiosity.output.file.AtomicFile;
import radiosity.output.gltf.LampMix;
import radiosity.output.gltf.LitScene;
import radiosity.scene.Affine;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;

/** The state of the window: scene, light, camera, and texts over the picture. All methods run on the event thread. */
public final class Display {

    private static final int EDGE = 12;
    /** Length of a probe's ray, relative to the sum of scene size and distance from eye to scene. */
    private static final double REACH = 2;

    private final Stage stage;
    private final WindowControls window;
    private final LightShader shader = new LightShader();
    private final Lighting lighting;
    private final Walker walker;
    private final Walking walking;
    private final Optional<Path> sceneFile;
    private final Photo photo;
    private final Editing editing;
    private Extent extent;
    private CompletableFuture<Optional<Obstacles>> obstacles;
    private SceneShapes shapes;
    private Runnable changed = () -> { };
    private boolean wireframe;
    private boolean textures;
    private boolean help;
    /** Mark where the probe was set, until the camera moves or the text changes. */
    private Optional<Overlay.Label> mark = Optional.empty();
    private List<String> status = List.of();

    /** Actions that only the window can perform. */
    interface WindowControls {
        /** Switches between full screen and window. */
        void fullScreen();

        /** Shows or hides the control panel. */
        void panel();

        void close();
    }

    Display(Stage stage, LitScene scene, ViewSettings settings, WindowControls window) {
        this.stage = stage;
        this.window = window;
        walker = new Walker(scene.camera(), this::allowed);
        walking = new Walking(walker, this::look, () -> extent.size());
        textures = settings.textures();
        lighting = new Lighting(settings, shader);
        sceneFile = settings.followed();
        photo = new Photo(sceneFile, this::status);
        editing = new Editing(this, settings.editing());
        show(scene);
        if (settings.wireframe()) {
            wireframe();
        }
        new Keys(this, walking).listenTo(stage.canvas());
        new Mouse(this).listenTo(stage.canvas());
    }

    Walking walking() {
        return walking;
    }

    Lighting lighting() {
        return lighting;
    }

    Editing editing() {
        return editing;
    }

    /** Height of the window's picture, pixels. */
    int height() {
        return Math.max(1, stage.canvas().getHeight());
    }

    boolean showsWireframe() {
        return wireframe;
    }

    boolean showsTextures() {
        return textures;
    }

    boolean collides() {
        return walker.collides();
    }

    /** @param listener called after each change of the state shown */
    void whenChanged(Runnable listener) {
        changed = listener;
    }

    /** Shows another scene, with the camera where it is. */
    void show(LitScene other) {
        lighting.show(other);
        shown();
        settled();
    }

    /** Shows the light of an edited scene at the same exposure. Walls stop nobody until {@link #settled} is called. */
    void follow(LitScene other) {
        lighting.follow(other);
        obstacles = CompletableFuture.completedFuture(Optional.empty());
        shown();
    }

    private void shown() {
        extent = Extent.of(lighting.scene());
        surfaces();
        look();
    }

    /** Prepares the obstacles of the scene shown, which is not expected to change soon. */
    void settled() {
        LitScene scene = lighting.scene();
        obstacles = orNothing(CompletableFuture.supplyAsync(() -> new Obstacles(scene)));
    }

    /** Builds the scene's shapes anew, with the selected object apart. */
    void select() {
        surfaces();
        stage.redraw();
    }

    /** @param map from the position of the selected object in the light shown to the position to draw it at */
    void place(Affine map) {
        if (shapes != null) {
            shapes.place(map);
        }
    }

    private void surfaces() {
        try {
            LitScene scene = lighting.scene();
            shapes = null;
            if (textures && scene.textures().isPresent()) {
                stage.scene(TexturedShapes.of(scene.textures().get(), shader, SceneShapes.bounds(scene)));
            } else {
                shapes = new SceneShapes(scene, shader.vertices(), editing.selection());
                stage.scene(shapes.group());
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Switches between the light of textures and of vertices. */
    void textures() {
        textures = !textures;
        surfaces();
        status(lighting.scene().textures().isEmpty() ? "no textures: they are made by RadiosityRenderer -ut"
                : textures ? "textures" : "vertices");
    }

    /** Shows a scene file that was read again, and reports that. */
    void replace(LitScene other) {
        show(other);
        status("read again: " + other.progress());
    }

    /** Returns nothing where the obstacles cannot be made, as for lack of memory, and reports the failure once. */
    static CompletableFuture<Optional<Obstacles>> orNothing(CompletableFuture<Obstacles> making) {
        return making.handle((made, failure) -> {
            if (failure != null) {
                Throwable cause = failure instanceof CompletionException ? failure.getCause() : failure;
                System.err.println("viewer: expected memory for what is in the way, got " + cause.getMessage()
                        + "; walls let you through, and a click tells nothing");
            }
            return Optional.ofNullable(made);
        });
    }

    /** Limits a step by walls; until the obstacles of a large scene are ready, nothing stops a step. */
    private Vec3 allowed(Vec3 eye, Vec3 step) {
        return obstacles.getNow(Optional.empty()).map(known -> known.allowed(eye, step)).orElse(step);
    }

    void look() {
        stage.look(camera(), lighting.scene().origin(), extent);
        if (mark.isPresent()) {
            mark = Optional.empty();
            overlay();
        }
    }

    /** Adapts camera and texts to a window of another size. */
    void resized() {
        look();
        overlay();
    }

    Camera camera() {
        return walker.camera((double) Math.max(1, stage.canvas().getWidth()) / height());
    }

    void turn(double left, double up) {
        walker.turn(left, up);
        look();
    }

    /** @param ahead distance relative to the scene's size */
    void walk(double ahead) {
        walker.walk(ahead * extent.size(), 0, 0);
        look();
    }

    void home() {
        walker.stand(lighting.scene().camera());
        quiet();
        look();
    }

    /** Removes all text over the picture. */
    void quiet() {
        help = false;
        status(List.of());
    }

    void collisions() {
        walker.collide(!walker.collides());
        status("walls " + (walker.collides() ? "stop you" : "let you through"));
    }

    /** Changes exposure or tone mapping, and shows the new values. */
    void light(Runnable change) {
        change.run();
        status(lighting.text());
    }

    /** Dims or colours the lamps of one name, see {@link LampMix#groups()}. */
    public void lamp(int group, Rgb factor) {
        mix(lighting.mix().with(group, factor));
    }

    /** Shows a mix. Textures hold the light as rendered, so the light of vertices is shown then. */
    void mix(LampMix mix) {
        lighting.mix(mix);
        lampsChanged();
    }

    /** Saves the mix beside the scene file, as {@code a.scene.mix}. */
    void saveMix() {
        withMixFile(file -> {
            AtomicFile.write(file, lighting.mix().text().getBytes(StandardCharsets.UTF_8));
            status("mix saved: " + file.getFileName());
        });
    }

    /** Shows the mix that was saved last. */
    void loadMix() {
        withMixFile(file -> mix(lighting.mix().read(Files.readString(file), file.getFileName().toString())));
    }

    /** What is done with a file. */
    private interface FileAction {
        void with(Path file) throws IOException;
    }

    private void withMixFile(FileAction action) {
        try {
            Path scene = sceneFile.orElseThrow(() -> new IOException("expected a scene file"));
            action.with(scene.resolveSibling(scene.getFileName() + ".mix"));
        } catch (NoSuchFileException e) {
            status("mix: none is saved");
        } catch (IOException e) {
            status("mix: " + e.getMessage());
        }
    }

    private void lampsChanged() {
        textures = false;
        if (shapes == null) {
            surfaces();
        } else {
            shapes.light(lighting.scene());
        }
        overlay();
    }

    void falseColour() {
        lighting.falseColour(!lighting.falseColour());
        overlay();
    }

    void wireframe() {
        wireframe = !wireframe;
        shader.wireframe(wireframe);
        changed.run();
    }

    void help() {
        help = !help;
        overlay();
    }

    void fullScreen() {
        window.fullScreen();
    }

    void panel() {
        window.panel();
    }

    /** Closes the window, but only at the second request where edits are not saved. */
    void leave() {
        if (!editing.holdsBack()) {
            window.close();
        }
    }

    /** Selects an object while editing is on; otherwise shows the light at a pixel of the window. */
    void click(int x, int y) {
        if (editing.isOn()) {
            editing.click(x, y);
        } else {
            probe(x, y);
        }
    }

    /** Unit direction from the eye through a pixel of the window. */
    Vec3 direction(int x, int y) {
        return camera().direction((2.0 * x + 1) / stage.canvas().getWidth() - 1,
                1 - (2.0 * y + 1) / stage.canvas().getHeight());
    }

    /** Shows the light at the surface under a pixel of the window; waits for the obstacles. */
    Optional<Probe> probe(int x, int y) {
        Camera camera = camera();
        Vec3 direction = direction(x, y);
        double far = REACH * (extent.size() + camera.position().minus(extent.centre()).length());
        Optional<Probe> probe = obstacles.join().flatMap(known -> known.hit(camera.position(), direction, far))
                .map(hit -> Probe.of(hit, lighting.scene().meshes().get(hit.mesh()), camera.position()
                        .plus(direction.times(hit.distance())), lighting.scene().units()));
        status(probe.map(Probe::lines).orElse(List.of()));
        mark = probe.map(hit -> new Overlay.Label(Overlay.mark(), x - Overlay.MARK / 2, y - Overlay.MARK / 2));
        overlay();
        return probe;
    }

    private void status(String line) {
        status(List.of(line));
    }

    /** Lines of text over the bottom of the picture. */
    List<String> status() {
        return status;
    }

    void status(List<String> lines) {
        status = lines;
        mark = Optional.empty();
        overlay();
    }

    private void overlay() {
        List<Overlay.Label> labels = new ArrayList<>();
        int height = stage.canvas().getHeight();
        int width = stage.canvas().getWidth();
        if (!status.isEmpty()) {
            BufferedImage text = Overlay.text(status);
            labels.add(new Overlay.Label(text, EDGE, height - text.getHeight() - EDGE));
        }
        mark.ifPresent(labels::add);
        if (lighting.falseColour()) {
            BufferedImage scale = Overlay.scale(lighting.toneMapping(), lighting.scene().units());
            labels.add(new Overlay.Label(scale, width - scale.getWidth() - EDGE, EDGE));
        }
        if (help) {
            labels.add(new Overlay.Label(Overlay.help(), EDGE, EDGE));
        }
        stage.canvas().overlay(Overlay.of(labels, width, height));
        stage.redraw();
        changed.run();
    }

    /** Draws a picture of the present view with mirrors and glass into a file. */
    void photo() {
        photo.take(lighting.scene(), camera(), Math.max(1, stage.canvas().getWidth()), lighting.toneMapping());
    }

    void close() {
        photo.close();
        editing.close();
        walking.stop();
    }
}
