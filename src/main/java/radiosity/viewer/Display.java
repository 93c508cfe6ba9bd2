package radiosity.viewer;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import radiosity.output.LitScene;
import radiosity.output.ToneMapping;
import radiosity.scene.Camera;
import radiosity.scene.Vec3;

/** What the window shows just now, and how; on the event thread. */
final class Display {

    private static final int EDGE = 12;
    /** How far a click reaches, of the scene's size and the distance to it. */
    private static final double REACH = 2;

    private final Stage stage;
    private final ViewSettings settings;
    private final WindowControls window;
    private final LightShader shader = new LightShader();
    private final Walker walker;
    private final Walking walking;
    private LitScene scene;
    private Extent extent;
    private CompletableFuture<Obstacles> obstacles;
    private ToneMapping toneMapping;
    /** The exposure for the scene as it is now. */
    private double automaticExposure;
    private boolean wireframe;
    private boolean textures;
    private boolean falseColour;
    private boolean help;
    /** Whether the exposure follows the scene. */
    private boolean automatic;
    private List<String> status = List.of();

    /** What only the window can do. */
    interface WindowControls {
        /** Fills the screen, or no longer. */
        void fullScreen();

        void close();
    }

    Display(Stage stage, LitScene scene, ViewSettings settings, WindowControls window) {
        this.stage = stage;
        this.settings = settings;
        this.window = window;
        walker = new Walker(scene.camera(), this::allowed);
        walking = new Walking(walker, this::look, () -> extent.size());
        textures = settings.textures();
        automatic = settings.toneMapping().isEmpty();
        toneMapping = settings.toneMapping().orElse(new ToneMapping(settings.curve(), 1));
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

    /** Shows another scene from where the user stands. */
    void show(LitScene other) {
        scene = other;
        extent = Extent.of(other);
        obstacles = CompletableFuture.supplyAsync(() -> new Obstacles(other));
        automaticExposure = ToneMapping.automatic(settings.curve(), other.meshes(), settings.stops()).exposure();
        toneMapping(automatic ? automaticExposure : toneMapping.exposure(), toneMapping.operator());
        surfaces();
        look();
    }

    private void surfaces() {
        try {
            stage.scene(textures && scene.textures().isPresent()
                    ? TexturedShapes.of(scene.textures().get(), shader, SceneShapes.bounds(scene))
                    : SceneShapes.of(scene, shader.vertices()));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Light of textures or of vertices. */
    void textures() {
        textures = !textures;
        surfaces();
        status(scene.textures().isEmpty() ? "no textures: they are made by RadiosityRenderer -ut"
                : textures ? "textures" : "vertices");
    }

    /** As {@link #show}, and says so. */
    void replace(LitScene other) {
        show(other);
        status("read again: " + other.progress());
    }

    /** Until the obstacles of a large scene are known nothing is in the way. */
    private Vec3 allowed(Vec3 eye, Vec3 step) {
        Obstacles known = obstacles.getNow(null);
        return known == null ? step : known.allowed(eye, step);
    }

    void look() {
        stage.look(camera(), scene.origin(), extent);
    }

    /** Puts everything where it belongs in a window of another size. */
    void resized() {
        look();
        overlay();
    }

    Camera camera() {
        int height = Math.max(1, stage.canvas().getHeight());
        return walker.camera((double) Math.max(1, stage.canvas().getWidth()) / height);
    }

    void turn(double left, double up) {
        walker.turn(left, up);
        look();
    }

    /** @param ahead of the scene's size */
    void walk(double ahead) {
        walker.walk(ahead * extent.size(), 0, 0);
        look();
    }

    void home() {
        walker.stand(scene.camera());
        quiet();
        look();
    }

    /** Removes the text that lies over the picture. */
    void quiet() {
        help = false;
        status(List.of());
    }

    void collisions() {
        walker.collide(!walker.collides());
        status("walls " + (walker.collides() ? "stop you" : "let you through"));
    }

    void brighter(double stops) {
        automatic = false;
        light(toneMapping.exposure() * Math.pow(2, stops), toneMapping.operator());
    }

    void automaticExposure() {
        automatic = true;
        light(automaticExposure, toneMapping.operator());
    }

    void nextCurve() {
        ToneMapping.Operator[] all = ToneMapping.Operator.values();
        light(toneMapping.exposure(), all[(toneMapping.operator().ordinal() + 1) % all.length]);
    }

    private void toneMapping(double exposure, ToneMapping.Operator curve) {
        toneMapping = new ToneMapping(curve, exposure);
        shader.toneMapping(toneMapping);
    }

    ToneMapping toneMapping() {
        return toneMapping;
    }

    /** Another tone mapping, and says which. */
    private void light(double exposure, ToneMapping.Operator curve) {
        toneMapping(exposure, curve);
        status(String.format(Locale.ROOT, "exposure %.4g per W/m² (%+.2f EV)   %s", exposure,
                Math.log(exposure / automaticExposure) / Math.log(2), curve.name().toLowerCase(Locale.ROOT)));
    }

    void falseColour() {
        falseColour = !falseColour;
        shader.falseColour(falseColour);
        overlay();
    }

    void wireframe() {
        wireframe = !wireframe;
        shader.wireframe(wireframe);
    }

    void help() {
        help = !help;
        overlay();
    }

    void fullScreen() {
        window.fullScreen();
    }

    void leave() {
        window.close();
    }

    /** Says what light there is under a pixel of the window. */
    Optional<Probe> probe(int x, int y) {
        Camera camera = camera();
        Vec3 direction = camera.direction((2.0 * x + 1) / stage.canvas().getWidth() - 1,
                1 - (2.0 * y + 1) / stage.canvas().getHeight());
        double far = REACH * (extent.size() + camera.position().minus(extent.centre()).length());
        Optional<Probe> probe = obstacles.join().hit(camera.position(), direction, far)
                .map(hit -> Probe.of(hit, camera.position().plus(direction.times(hit.distance()))));
        status(probe.map(Probe::lines).orElse(List.of()));
        return probe;
    }

    private void status(String line) {
        status(List.of(line));
    }

    private void status(List<String> lines) {
        status = lines;
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
        if (falseColour) {
            BufferedImage scale = Overlay.scale(toneMapping);
            labels.add(new Overlay.Label(scale, width - scale.getWidth() - EDGE, EDGE));
        }
        if (help) {
            labels.add(new Overlay.Label(Overlay.help(), EDGE, EDGE));
        }
        stage.canvas().overlay(Overlay.of(labels, width, height));
        stage.redraw();
    }

    void close() {
        walking.stop();
    }
}
