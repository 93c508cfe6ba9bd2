package radiosity.lightwave;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Surface;

/** The surfaces of a scene, each under a name of its own: equal ones of one name are one, others carry their object's. */
final class SurfaceTable {

    private static final int LONGEST_NAME = 200;

    private final LightWaveOptions options;
    private final Notes notes;
    private final List<Surface> surfaces = new ArrayList<>();
    private final List<SurfaceValues> described = new ArrayList<>();
    private final Map<String, Integer> byName = new HashMap<>();
    private final Map<SurfaceValues, Integer> known = new IdentityHashMap<>();

    SurfaceTable(LightWaveOptions options, Notes notes) {
        this.options = options;
        this.notes = notes;
    }

    List<Surface> surfaces() {
        return surfaces;
    }

    /** What the files say of the surfaces, in the same order. */
    List<SurfaceValues> described() {
        return described;
    }

    /** Index of a surface of an object. */
    int index(String object, SurfaceValues values) {
        return known.computeIfAbsent(values, v -> add(object, v));
    }

    private int add(String object, SurfaceValues values) {
        String plain = SceneFormatException.escape(values.name.substring(0, Math.min(LONGEST_NAME,
                values.name.length())));
        String name = plain;
        for (int copy = 1;; copy++) {
            Surface surface = surface(name, values);
            Integer other = byName.get(name);
            if (other == null) {
                return append(surface, values);
            }
            if (surfaces.get(other).equals(surface)) {
                return other;
            }
            name = object + ":" + plain + (copy == 1 ? "" : "#" + surfaces.size());
        }
    }

    private int append(Surface surface, SurfaceValues values) {
        byName.put(surface.name(), surfaces.size());
        surfaces.add(surface);
        described.add(values);
        return surfaces.size() - 1;
    }

    private Surface surface(String name, SurfaceValues values) {
        Rgb exitance = options.emission() == LightWaveOptions.Emission.SPECULAR
                ? values.specularExitance(options.srgb()) : values.luminosityExitance(options.srgb());
        Rgb reflectance = values.reflectance(options.srgb());
        if (reflectance.max() > Surface.MAX_REFLECTANCE) {
            notes.note("", "reflectances of 1 and more are taken as " + Surface.MAX_REFLECTANCE, name);
        }
        if (values.transparency > 0) {
            notes.note("", "transparent surfaces are taken as opaque", name);
        }
        return new Surface(name, exitance, clipped(reflectance), values.twoSided,
                SurfaceImages.maps(values, options));
    }

    private static Rgb clipped(Rgb rgb) {
        return new Rgb(Math.min(rgb.r(), Surface.MAX_REFLECTANCE), Math.min(rgb.g(), Surface.MAX_REFLECTANCE),
                Math.min(rgb.b(), Surface.MAX_REFLECTANCE));
    }
}
