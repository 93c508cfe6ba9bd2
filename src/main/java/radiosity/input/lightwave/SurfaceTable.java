package radiosity.input.lightwave;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import radiosity.input.file.Diagnostics;
import radiosity.input.lightwave.lwo.SurfaceValues;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Surface;
import radiosity.settings.ReadOptions;

/**
 * The surfaces of a scene under unique names. Equal surfaces with the same name are merged; different surfaces with the
 * same name get the name of their object as a prefix.
 */
final class SurfaceTable {

    private static final int LONGEST_NAME = 200;

    private final ReadOptions options;
    private final Diagnostics notes;
    private final List<Surface> surfaces = new ArrayList<>();
    private boolean isAnySpecular;
    private final Map<String, Integer> byName = new HashMap<>();
    private final Map<SurfaceValues, Integer> known = new IdentityHashMap<>();
    /** Lowest number not yet tried as a suffix, by prefixed name. */
    private final Map<String, Integer> nextCopy = new HashMap<>();

    SurfaceTable(ReadOptions options, Diagnostics notes) {
        this.options = options;
        this.notes = notes;
    }

    List<Surface> surfaces() {
        return surfaces;
    }

    /** Whether the object files describe any of the surfaces as specular. */
    boolean isAnySpecular() {
        return isAnySpecular;
    }

    /** Index of a surface of an object; a surface that is not in the table is added. */
    int index(String object, SurfaceValues values) {
        return known.computeIfAbsent(values, v -> add(object, v));
    }

    /**
     * Index of the surface under the first name that no different surface has: its own, its own prefixed by the
     * object's, or the latter with a number. Each number is tried once only: n different surfaces of one name cost
     * O(n).
     */
    private int add(String object, SurfaceValues values) {
        String plain = SceneFormatException.escape(values.name.substring(0, Math.min(LONGEST_NAME,
                values.name.length())));
        String copy = object + ":" + plain;
        for (String name : List.of(plain, copy)) {
            Surface surface = surface(name, values);
            if (isFreeOrEqual(surface)) {
                return indexOf(surface, values);
            }
        }
        int number = Math.max(nextCopy.getOrDefault(copy, 0), surfaces.size());
        Surface surface = surface(copy + "#" + number, values);
        while (!isFreeOrEqual(surface)) {
            surface = surface(copy + "#" + ++number, values);
        }
        nextCopy.put(copy, number + 1);
        return indexOf(surface, values);
    }

    private boolean isFreeOrEqual(Surface surface) {
        Integer other = byName.get(surface.name());
        return other == null || surfaces.get(other).equals(surface);
    }

    private int indexOf(Surface surface, SurfaceValues values) {
        Integer known = byName.get(surface.name());
        return known == null ? append(surface, values) : known;
    }

    private int append(Surface surface, SurfaceValues values) {
        byName.put(surface.name(), surfaces.size());
        surfaces.add(surface);
        isAnySpecular |= values.specular > 0;
        return surfaces.size() - 1;
    }

    private Surface surface(String name, SurfaceValues values) {
        Rgb exitance = options.emission() == ReadOptions.Emission.SPECULAR
                ? values.specularExitance(options.srgb()) : values.luminosityExitance(options.srgb());
        Rgb reflectance = values.reflectance(options.srgb());
        if (reflectance.max() > Surface.MAX_REFLECTANCE) {
            notes.note("", "reflectances of 1 and more are taken as " + Surface.MAX_REFLECTANCE, name);
        }
        if (values.transparency > 0) {
            notes.note("", "transparent surfaces let no light through; pictures show what is behind them", name);
        }
        return new Surface(name, exitance, reflectance.atMost(Surface.MAX_REFLECTANCE), values.twoSided,
                SurfaceImages.maps(values, options)).with(values.toSpecular()).smoothed(values.smoothing);
    }
}
