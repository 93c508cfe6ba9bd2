package radiosity.input.gltf;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import radiosity.gltf.JsonCursor;
import radiosity.input.file.Diagnostics;
import radiosity.input.photometry.Photometry;
import radiosity.scene.Affine;
import radiosity.scene.Camera;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Vec3;

/** The lights (KHR_lights_punctual, EXT_lights_ies) and the camera of a scene; both face along -z of their nodes. */
final class Views {

    /** Width of a picture / its height where a camera leaves it open. */
    private static final double ASPECT = 16.0 / 9;
    private static final double QUARTER = Math.PI / 4;

    private final JsonCursor root;
    private final Buffers buffers;
    private final Diagnostics notes;
    /** Names of lights that luminaires replace, which take their places and colours, not their intensities. */
    private final Set<String> replaced;
    private final List<Light> lights = new ArrayList<>();
    private Optional<Camera> camera = Optional.empty();

    Views(JsonCursor root, Buffers buffers, Diagnostics notes, Set<String> replaced) {
        this.root = root;
        this.buffers = buffers;
        this.notes = notes;
        this.replaced = replaced;
    }

    List<Light> lights() {
        return lights;
    }

    /** The first camera of the scene. */
    Optional<Camera> camera() {
        return camera;
    }

    /** Adds the lights and the camera of a node, where it has any. */
    void add(Nodes.Placed at) throws IOException {
        Optional<JsonCursor> light = at.node().extension("KHR_lights_punctual");
        if (light.isPresent()) {
            JsonCursor all = root.extension("KHR_lights_punctual").orElseThrow(
                    () -> root.wrong("lights in extensions/KHR_lights_punctual"));
            addLight(all.at("lights").at(light.get().at("light").integer()), at);
        }
        Optional<JsonCursor> luminaire = at.node().extension("EXT_lights_ies");
        if (luminaire.isPresent()) {
            addLuminaire(luminaire.get(), at);
        }
        if (at.node().optional("camera").isPresent() && camera.isEmpty()) {
            camera = camera(root.at("cameras").at(at.node().at("camera").integer()), at);
        }
    }

    private static Vec3 vec(double[] d) {
        return new Vec3(d[0], d[1], d[2]);
    }

    private static Vec3 position(Affine world) {
        return new Vec3(world.m()[3], world.m()[7], world.m()[11]);
    }

    /** Adds a luminaire of EXT_lights_ies: it shines along -z; its plane of horizontal angle 0 contains x and z. */
    private void addLuminaire(JsonCursor light, Nodes.Placed at) throws IOException {
        JsonCursor file = root.extension("EXT_lights_ies").orElseThrow(
                () -> root.wrong("lights in extensions/EXT_lights_ies")).at("lights").at(light.at("light").integer());
        Photometry photometry = Photometry.of(buffers.file(file), file.file() + " " + file.path());
        double[] colour = light.numbers("color", 1, 1, 1);
        double factor = light.number("multiplier", 1);
        Vec3 down = vec(at.world().direction(0, 0, -1));
        Vec3 zero = vec(at.world().direction(1, 0, 0));
        Vec3 position = position(at.world());
        if (!(Math.min(factor, Math.min(colour[0], Math.min(colour[1], colour[2]))) >= 0)) {
            throw light.wrong("a multiplier and a color of at least 0");
        }
        Rgb power = new Rgb(colour[0], colour[1], colour[2]).times(factor);
        boolean isSomewhere = position.isFinite() && down.isFinite() && zero.isFinite() && down.length() > 0;
        if (!isSomewhere || !(power.max() > 0) || !(photometry.intensity().max() > 0)) {
            notes.note(light.path(), "lights are left out that are nowhere, scaled to nothing or dark");
            return;
        }
        lights.add(photometry.at(at.node().text("name", file.text("name", "luminaire")), position, down, zero, power,
                1));
    }

    private void addLight(JsonCursor light, Nodes.Placed at) throws SceneFormatException {
        double[] colour = light.numbers("color", 1, 1, 1);
        double intensity = light.number("intensity", 1);
        String name = light.text("name", at.node().text("name", "light"));
        Rgb power = new Rgb(Math.max(0, colour[0]), Math.max(0, colour[1]), Math.max(0, colour[2]))
                .times(intensity == 0 && replaced.contains(name) ? 1 : Math.max(0, intensity));
        if (Math.min(intensity, Math.min(colour[0], Math.min(colour[1], colour[2]))) < 0) {
            notes.note(light.path(), "negative intensities and colors of lights count as 0");
        }
        String type = light.at("type").text();
        Optional<Light.Kind> kind = switch (type) {
            case "directional" -> Optional.of(Light.Kind.DISTANT);
            case "point" -> Optional.of(Light.Kind.POINT);
            case "spot" -> Optional.of(Light.Kind.SPOT);
            default -> Optional.empty();
        };
        Vec3 direction = vec(at.world().direction(0, 0, -1)).unit();
        Vec3 position = position(at.world());
        if (kind.isEmpty()) {
            notes.note(light.path(), "lights of a kind that is not known are left out", type);
            return;
        }
        if (!position.isFinite() || !(direction.length() > 0.5) || !direction.isFinite() || !power.isFinite()) {
            notes.note(light.path(), "lights are left out that are nowhere, or scaled to nothing");
            return;
        }
        if (power.max() > 0) {
            Optional<JsonCursor> spot = light.optional("spot");
            double outer = spot.isEmpty() ? QUARTER : angle(spot.get().number("outerConeAngle", QUARTER));
            double inner = spot.isEmpty() ? 0 : angle(spot.get().number("innerConeAngle", 0));
            lights.add(new Light(name, kind.get(), power, position,
                    direction, vec(at.world().direction(1, 0, 0)).unit(), Vec3.ZERO, 1, outer,
                    Math.max(0, outer - inner)));
        }
    }

    private static double angle(double written) {
        return Math.max(0, Math.min(Math.PI / 2, written));
    }

    private Optional<Camera> camera(JsonCursor written, Nodes.Placed at) throws SceneFormatException {
        Optional<JsonCursor> perspective = written.optional("perspective");
        if (perspective.isEmpty()) {
            notes.note(written.path(), "cameras without perspective are left out");
            return Optional.empty();
        }
        Optional<Camera> found = Camera.of(position(at.world()), vec(at.world().direction(0, 0, -1)),
                vec(at.world().direction(0, 1, 0)), perspective.get().at("yfov").number() / 2,
                perspective.get().number("aspectRatio", ASPECT));
        if (found.isEmpty()) {
            notes.note(written.path(), "a camera without a sound position, angle or picture size is left out");
        }
        return found;
    }
}
