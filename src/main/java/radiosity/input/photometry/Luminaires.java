package radiosity.input.photometry;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;
import radiosity.util.Decimal;

/** Replaces a scene's lights by luminaires of the same name, and adds luminaires at given positions. */
public final class Luminaires {

    private static final Vec3 DOWN = new Vec3(0, -1, 0);

    private Luminaires() { }

    /**
     * The scene with the luminaires of the options. A luminaire replaces each light of its name and takes the light's
     * colour, not its intensity, and its direction unless it is a point light. A luminaire named x,y,z hangs there.
     * Luminaires without direction shine straight down.
     *
     * @return the scene itself without luminaires, else a photometric scene
     * @throws SceneFormatException where no light has a name, the unit of length is not known, or a file is invalid
     * @throws IOException          where a file cannot be read
     */
    public static Scene place(Scene scene, ReadOptions options) throws IOException {
        if (options.luminaires().isEmpty()) {
            return scene;
        }
        if (!scene.units().isLengthKnown()) {
            throw new SceneFormatException(scene.name(), "", "a unit of length (--unit) for luminaires, whose intensity"
                    + " is in cd", "none");
        }
        List<Light> lights = new ArrayList<>(scene.lights());
        Set<String> names = new TreeSet<>(options.luminaires().keySet());
        for (String name : names) {
            Path file = options.luminaires().get(name);
            Vec3 place = place(name);
            boolean found = lights.stream().anyMatch(light -> light.name().equals(name));
            if (!found && place == null) {
                String there = scene.lights().stream().map(Light::name).distinct().limit(20)
                        .collect(Collectors.joining(", "));
                throw new SceneFormatException(scene.name(), "", "a light that is called " + name
                        + " (--luminaire), or three coordinates x,y,z", there.isEmpty() ? "no lights" : there);
            }
            Photometry luminaire = Photometry.read(file, options.maxBytes());
            for (int i = 0; i < lights.size(); i++) {
                if (lights.get(i).name().equals(name)) {
                    lights.set(i, at(lights.get(i), luminaire, scene, file));
                }
            }
            if (!found) {
                lights.add(luminaire(luminaire, name, place, DOWN, Vec3.ZERO, Rgb.grey(1), scene, file));
            }
        }
        return scene.with(scene.surfaces(), lights).with(scene.units().withPhotometric(true));
    }

    private static Light at(Light light, Photometry luminaire, Scene scene, Path file) throws SceneFormatException {
        boolean aimed = light.direction().length() > 0 && light.kind() != Light.Kind.POINT;
        double luminance = scene.units().withPhotometric(true).total(light.power());
        return luminaire(luminaire, light.name(), light.position(), aimed ? light.direction() : DOWN, light.right(),
                light.power().times(1 / luminance), scene, file);
    }

    private static Light luminaire(Photometry luminaire, String name, Vec3 place, Vec3 down, Vec3 zero, Rgb colour,
                                   Scene scene, Path file) throws SceneFormatException {
        try {
            return luminaire.at(name, place, down, zero, colour, scene.units().metre());
        } catch (IllegalArgumentException e) {
            throw new SceneFormatException(file.toString(), "", "a luminaire that shines", e.getMessage());
        }
    }

    /** The position that a name of three coordinates stands for; null for other names. */
    private static Vec3 place(String name) {
        String[] words = name.split(",", -1);
        double[] x = new double[words.length];
        for (int i = 0; i < words.length; i++) {
            x[i] = Decimal.parse(words[i].strip());
        }
        Vec3 place = words.length == 3 ? new Vec3(x[0], x[1], x[2]) : null;
        return place != null && place.isFinite() ? place : null;
    }
}
