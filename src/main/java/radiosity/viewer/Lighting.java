package radiosity.viewer;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import radiosity.output.gltf.LampMix;
import radiosity.output.gltf.LitScene;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Camera;
import radiosity.scene.Units;

/** The light in which a scene is shown: factors of the lamps, exposure and tone mapping; on the event thread. */
final class Lighting {

    private final ViewSettings settings;
    private final LightShader shader;
    /** Scene with its lamps as rendered. */
    private LitScene scene;
    /** Scene with its lamps as they are set. */
    private LitScene lit;
    private LampMix mix = LampMix.asRendered(List.of());
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

    /** Shows another scene; the mix is kept where both scenes have the same lamps. */
    void show(LitScene other) {
        follow(other);
        automaticExposure = automatic(lit, lit.camera());
        toneMapping(automatic ? automaticExposure : toneMapping.exposure(), toneMapping.operator());
    }

    /** Shows an edited version of the scene, with the exposure kept. */
    void follow(LitScene other) {
        scene = other;
        mix(mix.lamps().equals(other.lamps()) ? mix : LampMix.asRendered(other.lamps()));
    }

    LampMix mix() {
        return mix;
    }

    /** Applies a mix; if it is as rendered, takes the rendered scene itself, so that not even rounding differs. */
    void mix(LampMix other) {
        mix = other;
        lit = mix.isAsRendered() ? scene : scene.mixed(mix.factors());
    }

    private double automatic(LitScene of, Camera camera) {
        return ToneMapping.automatic(settings.curve(), of.meshes(), Optional.of(camera), settings.stops()).exposure();
    }

    /** The scene with its lamps as they are set. */
    LitScene scene() {
        return lit;
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

    /** Sets the exposure that suits what is before a camera with the present lamps, and keeps it automatic. */
    void automaticExposure(Camera camera) {
        automatic = true;
        automaticExposure = automatic(lit, camera);
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
