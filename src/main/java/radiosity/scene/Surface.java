package radiosity.scene;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * How a set of triangles emits and reflects: on the visible side only, or on both sides if two-sided.
 *
 * @param name        unique within its scene
 * @param exitance    E, emitted radiosity in W/m², each channel finite and at least 0; or the mean of its map
 * @param reflectance rho, reflected / arriving, each channel in [0, {@value #MAX_REFLECTANCE}]; or the mean of its map
 * @param twoSided    whether both sides reflect and emit
 * @param textures    images that vary exitance and reflectance, all by the triangle's one set of texture coordinates
 * @param maps        the pixels that were read from the textures' images; empty maps where none were read
 * @param specular    mirroring and transmission; empty for a purely diffuse surface
 * @param smoothing   largest angle between adjacent facets across which light is shown smoothly, radians in [0, pi];
 *                    0 for facets that are seen as such. The calculation does not depend on it.
 */
public record Surface(String name, Rgb exitance, Rgb reflectance, boolean twoSided, List<ImageMap> textures,
        Maps maps, Optional<Specular> specular, double smoothing) {

    /** Largest reflectance; readers clip larger ones to it and warn, as light would never fade at 1. */
    public static final double MAX_REFLECTANCE = 0.9999;

    /** Reflectance where the input gives none, or only an image that cannot be used: a light grey. */
    public static final double UNKNOWN_REFLECTANCE = 0.8;

    /**
     * Exitance and reflectance point by point; a quantity without a map is the same everywhere.
     *
     * @param exitance    W/m²
     * @param reflectance without unit
     */
    public record Maps(Optional<Raster> exitance, Optional<Raster> reflectance) {

        public static final Maps NONE = new Maps(Optional.empty(), Optional.empty());

        public boolean isEmpty() {
            return exitance.isEmpty() && reflectance.isEmpty();
        }
    }

    /** A surface without textures. */
    public Surface(String name, Rgb exitance, Rgb reflectance, boolean twoSided) {
        this(name, exitance, reflectance, twoSided, List.of());
    }

    /** A surface whose images were not read. */
    public Surface(String name, Rgb exitance, Rgb reflectance, boolean twoSided, List<ImageMap> textures) {
        this(name, exitance, reflectance, twoSided, textures, Maps.NONE);
    }

    /** A surface without mirroring and transmission. */
    public Surface(String name, Rgb exitance, Rgb reflectance, boolean twoSided, List<ImageMap> textures, Maps maps) {
        this(name, exitance, reflectance, twoSided, textures, maps, Optional.empty());
    }

    /** A surface whose facets are seen as such. */
    public Surface(String name, Rgb exitance, Rgb reflectance, boolean twoSided, List<ImageMap> textures, Maps maps,
                   Optional<Specular> specular) {
        this(name, exitance, reflectance, twoSided, textures, maps, specular, 0);
    }

    public Surface {
        textures = List.copyOf(textures);
        double mapped = maps.reflectance().map(Raster::most).orElse(0.0);
        if (mapped > (float) MAX_REFLECTANCE) {
            throw new IllegalArgumentException("surface " + name + ": expected an image of reflectances of at most "
                    + MAX_REFLECTANCE + ", got " + mapped);
        }
        if (!(smoothing >= 0 && smoothing <= Math.PI)) {
            throw new IllegalArgumentException("surface " + name + ": expected a smoothing angle from 0 to pi, got "
                    + smoothing);
        }
        for (int c = 0; c < 3; c++) {
            double e = exitance.channel(c);
            double rho = reflectance.channel(c);
            if (!(e >= 0 && e <= Double.MAX_VALUE)) {
                throw new IllegalArgumentException("surface " + name + ": expected an exitance of at least 0, got "
                        + e);
            }
            if (!(rho >= 0 && rho <= MAX_REFLECTANCE)) {
                throw new IllegalArgumentException("surface " + name + ": expected a reflectance in [0, "
                        + MAX_REFLECTANCE + "], got " + rho);
            }
        }
    }

    /** This surface with maps; exitance and reflectance become the means of their maps, where there are maps. */
    public Surface with(Maps read) {
        return new Surface(name, read.exitance().map(Raster::mean).orElse(exitance),
                read.reflectance().map(Raster::mean).orElse(reflectance), twoSided, textures, read, specular,
                smoothing);
    }

    /** This surface where the image of its reflectance cannot be used. */
    public Surface withoutImage() {
        return new Surface(name, exitance, withoutImage(reflectance), twoSided, textures, maps, specular, smoothing);
    }

    /**
     * The reflectance where an image cannot be used that it would have been multiplied by. White says nothing of the
     * surface then: a light grey is returned for it, and the reflectance itself for all else.
     */
    public static Rgb withoutImage(Rgb reflectance) {
        boolean isWhite = Math.min(reflectance.r(), Math.min(reflectance.g(), reflectance.b())) >= MAX_REFLECTANCE;
        return isWhite ? Rgb.grey(UNKNOWN_REFLECTANCE) : reflectance;
    }

    /** This surface with another exitance and without maps. */
    public Surface with(Rgb otherExitance) {
        return new Surface(name, otherExitance, reflectance, twoSided, textures, Maps.NONE, specular,
                smoothing);
    }

    /** This surface with other mirroring and transmission. */
    public Surface with(Optional<Specular> other) {
        return new Surface(name, exitance, reflectance, twoSided, textures, maps, other, smoothing);
    }

    /**
     * This surface with another smoothing angle.
     *
     * @param angle radians; 0 and below and NaN make facets that are seen as such, pi and above join all facets
     */
    public Surface smoothed(double angle) {
        return new Surface(name, exitance, reflectance, twoSided, textures, maps, specular,
                angle > 0 ? Math.min(angle, Math.PI) : 0);
    }

    /** Each quantity by the function of its map, or the surface's own value where there is no map. */
    MaterialSample material(Function<Raster, Rgb> value) {
        return new MaterialSample(maps.exitance().map(value).orElse(exitance),
                maps.reflectance().map(value).orElse(reflectance));
    }

    public boolean emits() {
        return exitance.max() > 0;
    }
}
