package radiosity.input.lightwave.lwo;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import radiosity.scene.Rgb;
import radiosity.scene.Specular;
import radiosity.scene.Srgb;

/**
 * A surface as an object describes it. Values that the file leaves out are null until {@link #complete}.
 *
 * <p>Diffuse, luminosity, specular, reflection, glossiness and transparency are shares, 1 = 100 %; they may be above 1.
 */
public final class SurfaceValues {

    /** LightWave's default grey. */
    private static final Rgb DEFAULT_COLOUR = Rgb.grey(200 / 255.0);
    private static final int MOST_TEXTURES = 16;
    private static final double USUAL_GLOSSINESS = 0.4;

    public final String name;
    /** Name of the surface that gives the values which this surface leaves out; empty if there is none. */
    final String source;
    public Rgb colour;
    public Double diffuse;
    public Double luminosity;
    public Double specular;
    public Double transparency;
    Double reflection;
    Double glossiness;
    /** Refractive index. */
    Double refraction;
    /** Colour of the emitted light; null where the surface's own colour is used. */
    public Rgb luminousColour;
    public Boolean twoSided;
    /** Largest angle between facets that are shown smoothly, radians; 0 and below for none. */
    public Double smoothing;
    public final List<TextureBlock> textures = new ArrayList<>(0);

    SurfaceValues(String name, String source) {
        this.name = name;
        this.source = source;
    }

    /** The surface of a polygon whose surface the object does not describe. */
    public static SurfaceValues standard(String name) {
        SurfaceValues standard = new SurfaceValues(name, "");
        standard.complete(false);
        return standard;
    }

    /** Adds an image; images beyond MOST_TEXTURES, more than any LightWave is known to write, are ignored. */
    void addTexture(TextureBlock texture) {
        if (textures.size() < MOST_TEXTURES) {
            textures.add(texture);
        }
    }

    /** Copies from another surface the values that this surface leaves out. */
    void inherit(SurfaceValues from) {
        colour = colour == null ? from.colour : colour;
        diffuse = diffuse == null ? from.diffuse : diffuse;
        luminosity = luminosity == null ? from.luminosity : luminosity;
        specular = specular == null ? from.specular : specular;
        transparency = transparency == null ? from.transparency : transparency;
        reflection = reflection == null ? from.reflection : reflection;
        glossiness = glossiness == null ? from.glossiness : glossiness;
        refraction = refraction == null ? from.refraction : refraction;
        luminousColour = luminousColour == null ? from.luminousColour : luminousColour;
        twoSided = twoSided == null ? from.twoSided : twoSided;
        smoothing = smoothing == null ? from.smoothing : smoothing;
        if (textures.isEmpty()) {
            textures.addAll(from.textures);
        }
    }

    /** Sets the values still left out: all zero in old objects, diffuse 1 and a light grey in newer ones. */
    void complete(boolean old) {
        SurfaceValues rest = new SurfaceValues(name, "");
        rest.colour = old ? Rgb.BLACK : DEFAULT_COLOUR;
        rest.diffuse = old ? 0.0 : 1.0;
        rest.luminosity = 0.0;
        rest.specular = 0.0;
        rest.transparency = 0.0;
        rest.reflection = 0.0;
        rest.glossiness = USUAL_GLOSSINESS;
        rest.refraction = 1.0;
        rest.twoSided = false;
        rest.smoothing = 0.0;
        inherit(rest);
    }

    /** rho before it is clipped to the largest reflectance of a surface; NaN and negative values become 0. */
    public Rgb reflectance(boolean srgb) {
        return sound(linear(colour, srgb).times(diffuse));
    }

    /** E in W/m², from the luminosity. */
    public Rgb luminosityExitance(boolean srgb) {
        return sound(linear(luminousColour == null ? colour : luminousColour, srgb).times(luminosity));
    }

    /** E in W/m², from the specular value, as in appendix B.2 of the paper. */
    public Rgb specularExitance(boolean srgb) {
        return sound(linear(colour, srgb).times(specular));
    }

    /**
     * Mirroring and transmission; empty where the surface does neither. An opaque mirror with highlights is as blurred
     * as the highlights are. A highlight is the cosine from the mirrored direction to the power n = 2^(10 glossiness +
     * 2) (LightWave's LWO2 file format); microfacets with slopes of width sqrt(2 / (4 n + 2)) have a highlight of that
     * width (B. Walter and others, Microfacet models for refraction through rough surfaces, 2007, appendix).
     */
    public Optional<Specular> toSpecular() {
        double r = share(reflection);
        double t = share(transparency);
        if (r == 0 && t == 0) {
            return Optional.empty();
        }
        double index = t > 0 && refraction > 0
                ? Math.max(Specular.LEAST_INDEX, Math.min(Specular.MOST_INDEX, refraction)) : 1;
        double mirrored = r + (1 - r) * Specular.normalReflectance(index);
        double exponent = StrictMath.pow(2, 10 * share(glossiness) + 2);
        boolean isBlurred = t == 0 && share(specular) > 0 && share(glossiness) < 1;
        return Optional.of(new Specular(Rgb.grey(mirrored), Rgb.grey(t * (1 - mirrored)), 1 - t,
                isBlurred ? StrictMath.pow(2 / (4 * exponent + 2), 0.25) : 0, index, twoSided));
    }

    private static double share(double value) {
        return Math.min(1, sound(value));
    }

    /** Replaces NaN and negative values by 0, and limits large ones to the largest float. */
    public static Rgb sound(Rgb rgb) {
        return new Rgb(sound(rgb.r()), sound(rgb.g()), sound(rgb.b()));
    }

    private static double sound(double value) {
        return value > 0 ? Math.min(value, Float.MAX_VALUE) : 0;
    }

    public static Rgb linear(Rgb rgb, boolean srgb) {
        return srgb ? Srgb.linear(rgb) : rgb;
    }
}
