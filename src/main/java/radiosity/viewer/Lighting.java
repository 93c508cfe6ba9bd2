package radiosity.viewer;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import radiosity.output.gltf.LitScene;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Lamp;
import radiosity.scene.Rgb;

/** In what light a scene is shown: how bright each lamp is, and how radiosity becomes colour; on the event thread. */
final class Lighting {

    private final ViewSettings settings;
    private final LightShader shader;
    /** As it was rendered. */
    private LitScene scene;
    /** With its lamps as they are now. */
    private LitScene lit;
    /** 1 per lamp: what its light is multiplied with. */
    private List<Rgb> factors = List.of();
    private ToneMapping toneMapping;
    /** The exposure for the scene as it is now. */
    private double automaticExposure;
    /** Whether the exposure follows the scene. */
    private boolean automatic;
    private boolean falseColour;

    Lighting(ViewSettings settings, LightShader shader) {
        this.settings = settings;
        this.shader = shader;
        automatic = settings.toneMapping().isEmpty();
        toneMapping = settings.toneMapping().orElse(new ToneMapping(settings.curve(), 1));
    }

    /** Another scene; its lamps stay as they were where it has the same. */
    void show(LitScene other) {
        if (scene == null || !scene.lamps().equals(other.lamps())) {
            factors = asRendered(other);
        }
        scene = other;
        mix();
        automaticExposure = automatic(lit);
        toneMapping(automatic ? automaticExposure : toneMapping.exposure(), toneMapping.operator());
    }

    /** The same scene, edited: it stays as bright as it was. */
    void follow(LitScene other) {
        factors = scene.lamps().equals(other.lamps()) ? factors : asRendered(other);
        scene = other;
        mix();
    }

    private static List<Rgb> asRendered(LitScene scene) {
        return Collections.nCopies(scene.lamps().size(), Rgb.grey(1));
    }

    /** As it was rendered nothing is added up: not even rounding differs. */
    private void mix() {
        lit = factors.equals(asRendered(scene)) ? scene : scene.mixed(factors);
    }

    private double automatic(LitScene of) {
        return ToneMapping.automatic(settings.curve(), of.meshes(), settings.stops()).exposure();
    }

    /** The scene with its lamps as they are now. */
    LitScene scene() {
        return lit;
    }

    List<Lamp> lamps() {
        return scene.lamps();
    }

    /** What a lamp's light is multiplied with. */
    Rgb lamp(int lamp) {
        return factors.get(lamp);
    }

    /** @param factor at least 0 */
    void lamp(int lamp, Rgb factor) {
        List<Rgb> changed = new ArrayList<>(factors);
        changed.set(lamp, factor);
        factors = changed;
        mix();
    }

    /** Puts out all other lamps; one that is out itself is as it was rendered. */
    void only(int lamp) {
        List<Rgb> changed = new ArrayList<>(Collections.nCopies(factors.size(), Rgb.BLACK));
        changed.set(lamp, factors.get(lamp).max() > 0 ? factors.get(lamp) : Rgb.grey(1));
        factors = changed;
        mix();
    }

    /** All lamps as they were rendered. */
    void reset() {
        factors = asRendered(scene);
        mix();
    }

    ToneMapping toneMapping() {
        return toneMapping;
    }

    /** How much brighter the picture is than by automatic exposure, EV. */
    double stops() {
        return Math.log(toneMapping.exposure() / automaticExposure) / Math.log(2);
    }

    void stops(double stops) {
        automatic = false;
        toneMapping(automaticExposure * Math.pow(2, stops), toneMapping.operator());
    }

    void brighter(double stops) {
        automatic = false;
        toneMapping(toneMapping.exposure() * Math.pow(2, stops), toneMapping.operator());
    }

    /** Follows the scene, with its lamps as they are now. */
    void automaticExposure() {
        automatic = true;
        automaticExposure = automatic(lit);
        toneMapping(automaticExposure, toneMapping.operator());
    }

    void curve(ToneMapping.Operator curve) {
        toneMapping(toneMapping.exposure(), curve);
    }

    void nextCurve() {
        ToneMapping.Operator[] all = ToneMapping.Operator.values();
        curve(all[(toneMapping.operator().ordinal() + 1) % all.length]);
    }

    private void toneMapping(double exposure, ToneMapping.Operator curve) {
        toneMapping = new ToneMapping(curve, exposure);
        shader.toneMapping(toneMapping);
    }

    boolean falseColour() {
        return falseColour;
    }

    void falseColour(boolean on) {
        falseColour = on;
        shader.falseColour(on);
    }

    /** For the user. */
    String text() {
        return String.format(Locale.ROOT, "exposure %.4g per W/m² (%+.2f EV)   %s", toneMapping.exposure(), stops(),
                toneMapping.operator().name().toLowerCase(Locale.ROOT));
    }
}
