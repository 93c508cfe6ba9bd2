package radiosity.scene;

import java.util.List;

/**
 * How a set of triangles emits and reflects. Diffuse; on the visible side only, or on both if two-sided.
 *
 * @param name        unique within its scene
 * @param exitance    E, emitted radiosity in W/m², each channel finite and at least 0
 * @param reflectance rho, reflected / arriving, each channel in [0, {@value #MAX_REFLECTANCE}]
 * @param twoSided    reflects and emits on both sides
 * @param textures    images that vary exitance and reflectance, all at the triangle's one set of texture coordinates;
 *                    mostly none
 */
public record Surface(String name, Rgb exitance, Rgb reflectance, boolean twoSided, List<ImageMap> textures) {

    /** A reader that finds a reflectance of 1 or more takes this instead and warns: at 1 light would never end. */
    public static final double MAX_REFLECTANCE = 0.9999;

    /** A surface without textures. */
    public Surface(String name, Rgb exitance, Rgb reflectance, boolean twoSided) {
        this(name, exitance, reflectance, twoSided, List.of());
    }

    public Surface {
        textures = List.copyOf(textures);
        for (int c = 0; c < 3; c++) {
            double e = exitance.channel(c);
            double rho = reflectance.channel(c);
            if (!(e >= 0 && e <= Double.MAX_VALUE)) {
                throw new IllegalArgumentException("surface " + name + ": expected an exitance of at least 0, got " + e);
            }
            if (!(rho >= 0 && rho <= MAX_REFLECTANCE)) {
                throw new IllegalArgumentException("surface " + name + ": expected a reflectance in [0, "
                        + MAX_REFLECTANCE + "], got " + rho);
            }
        }
    }

    public boolean emits() {
        return exitance.max() > 0;
    }
}
