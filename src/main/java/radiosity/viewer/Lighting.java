package radiosity.viewer;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import radiosity.output.gltf.LitScene;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Lamp;
import radiosity.scene.Rgb;
import radiosity.scene.Units;

/** The light in which a scene is shown: factors of the lamps, exposure and tone mapping; on the event thread. */
final class Lighting {

    private final ViewSettings settings;
    private final LightShader shader;
    /** Scene with its lamps as rendered. */
    private LitScene scene;
    /** Scene with its lamps as they are set. */
    private LitScene lit;
    /** 1 per lamp: factor of the lamp's light, per channel. */
    private List<Rgb> factors = List.of();
    private ToneMapping toneMapping;
    /** Exposure that suits the scene with its present lamps, 1 / (W/m²) or 1 / (lm/m²). */
    private double automaticExposure;
    /** Whether the exposure changes with the scene. */
    private boolean automatic;
    private boolean falseColour;

    Lighting(ViewSettings settings, LightShader shader) {
        this.settings = settings;
        this.shader = shader;
        automatic = settings.toneMapping().isEmpty();
        toneMapping = settings.toneMapping().orElse(new ToneMapping(settings.curve(), 1));
    }

    /** Shows another scene; factors are kept where both scenes have the same lamps. */
    void show(LitScene other) {
        if (scene == null || !scene.lamps().equals(other.lamps())) {
            factors = asRendered(other);
        }
        scene = other;
        mix();
        automaticExposure = automatic(lit);
        toneMapping(automatic ? automaticExposure : toneMapping.exposure(), toneMapping.operator());
    }

    /** Shows an edited version of the scene, with the exposure kept. */
    void follow(LitScene other) {
        factors = scene.lamps().equals(other.lamps()) ? factors : asRendered(other);
        scene = other;
        mix();
    }

    private static List<Rgb> asRendered(LitScene scene) {
        return Collections.nCopies(scene.lamps().size(), Rgb.grey(1));
    }

    /** Applies the factors; if none is changed, takes the rendered scene itself, so that not even rounding differs. */
    private void mix() {
        lit = factors.equals(asRendered(scene)) ? scene : scene.mixed(factors);
    }

    private double automatic(LitScene of) {
        return ToneMapping.automatic(settings.curve(), of.meshes(), settings.stops()).exposure();
    }

    /** The scene with its lamps as they are set. */
    LitScene scene() {
        return lit;
    }

    List<Lamp> lamps() {
        return scene.lamps();
    }

    /** Factor of a lamp's light, per channel. */
    Rgb lamp(int lamp) {
        return factors.get(lamp);
    }

    /** @param factor per channel, at least 0 */
    void lamp(int lamp, Rgb factor) {
        List<Rgb> changed = new ArrayList<>(factors);
        changed.set(lamp, factor);
        factors = changed;
        mix();
    }

    /** Turns off all other lamps; where the lamp itself is off, it gets the light as rendered. */
    void only(int lamp) {
        List<Rgb> changed = new ArrayList<>(Collections.nCopies(factors.size(), Rgb.BLACK));
        changed.set(lamp, factors.get(lamp).max() > 0 ? factors.get(lamp) : Rgb.grey(1));
        factors = changed;
        mix();
    }

    /** Resets all lamps to the light as rendered. */
    void reset() {
        factors = asRendered(scene);
        mix();
    }

    ToneMapping toneMapping() {
        return toneMapping;
    }

    /** How much brighter the picture is than at automatic exposure, EV. */
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

    /** Sets the exposure that suits the scene with its present lamps, and keeps it automatic. */
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

    /** Describes exposure and curve to the user. */
    String text() {
        return String.format(Locale.ROOT, "exposure %.4g per %s (%+.2f EV)   %s", toneMapping.exposure(),
                Units.raised(scene.units().exitance()), stops(),
                toneMapping.operator().name().toLowerCase(Locale.ROOT));
    }
}
