package radiosity.scene;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * How a set of triangles emits and reflects: on the visible side only, or on both if two-sided.
 *
 * @param name        unique within its scene
 * @param exitance    E, emitted radiosity in W/m², each channel finite and at least 0; the mean of its map, if any
 * @param reflectance rho, reflected / arriving, each channel in [0, {@value #MAX_REFLECTANCE}]; the mean of its map, if
 *                    any
 * @param twoSided    reflects and emits on both sides
 * @param textures    images that vary exitance and reflectance, all at the triangle's one set of texture coordinates;
 *                    mostly none
 * @param maps        what has become of them, where their images were read
 * @param specular    what else it does, where it shines
 */
public record Surface(String name, Rgb exitance, Rgb reflectance, boolean twoSided, List<ImageMap> textures,
        Maps maps, Optional<Specular> specular) {

    /** A reader that finds a reflectance of 1 or more takes this instead and warns: at 1 light would never end. */
    public static final double MAX_REFLECTANCE = 0.9999;

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

    /** A surface that does not shine. */
    public Surface(String name, Rgb exitance, Rgb reflectance, boolean twoSided, List<ImageMap> textures, Maps maps) {
        this(name, exitance, reflectance, twoSided, textures, maps, Optional.empty());
    }

    public Surface {
        textures = List.copyOf(textures);
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

    /** The same, with maps in place of what it is everywhere. */
    public Surface with(Maps read) {
        return new Surface(name, read.exitance().map(Raster::mean).orElse(exitance),
                read.reflectance().map(Raster::mean).orElse(reflectance), twoSided, textures, read, specular);
    }

    /** The same, with another exitance, without what its images vary. */
    public Surface with(Rgb otherExitance) {
        return new Surface(name, otherExitance, reflectance, twoSided, textures, Maps.NONE, specular);
    }

    /** The same, which shines so. */
    public Surface with(Optional<Specular> other) {
        return new Surface(name, exitance, reflectance, twoSided, textures, maps, other);
    }

    /** What its maps say, and the surface itself of a quantity without one. */
    MaterialSample look(Function<Raster, Rgb> value) {
        return new MaterialSample(maps.exitance().map(value).orElse(exitance),
                maps.reflectance().map(value).orElse(reflectance));
    }

    public boolean emits() {
        return exitance.max() > 0;
    }
}
