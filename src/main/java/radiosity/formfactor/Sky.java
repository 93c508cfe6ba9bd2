package radiosity.formfactor;

import java.util.function.Predicate;
import radiosity.scene.Light;
import radiosity.scene.Vec3;

/**
 * The light of a sky that a point receives through openings of any shape; see {@link SkyView}.
 *
 * <p>Luminances: CIE S 011/E:2003, Spatial distribution of daylight - CIE standard general sky.
 */
final class Sky {

    /** Parameters a to e of the CIE general sky of type 12: gradation (a, b) and scattering (c, d, e). */
    private static final double A = -1;
    private static final double B = -0.32;
    private static final double C = 10;
    private static final double D = -3;
    private static final double E = 0.45;

    private final Light light;
    private final Vec3 sun;
    /** Factor that makes the irradiance of a level place with a free sky 1. */
    private final double scale;

    Sky(Light light) {
        this.light = light;
        sun = light.direction().unit().times(-1);
        scale = 1 / new SkyView(this, light.up(), d -> true).mean();
    }

    /**
     * Irradiance of a point, relative to that of a level place with a free sky.
     *
     * @param n    normal of the point, length 1
     * @param free whether no triangle stands in the way in a direction from the point
     */
    double irradiance(Vec3 n, Predicate<Vec3> free) {
        return scale * new SkyView(this, n, free).mean();
    }

    Vec3 up() {
        return light.up();
    }

    /** Luminance in a direction of length 1; a sky of luminance 1 everywhere gives a level place an irradiance of 1. */
    double towards(Vec3 d) {
        double height = d.dot(light.up());
        return height <= 0 ? 0 : scale * luminance(d, height);
    }

    /** Luminance in direction d, in an arbitrary unit; height is the sine of the elevation, above 0. */
    double luminance(Vec3 d, double height) {
        return switch (light.kind()) {
            case SKY_OVERCAST -> 1 + 2 * height;
            case SKY_CLEAR -> {
                double angle = StrictMath.acos(Math.max(-1, Math.min(1, d.dot(sun))));
                double aboutSun = 1 + C * (StrictMath.exp(D * angle) - StrictMath.exp(D * Math.PI / 2))
                        + E * d.dot(sun) * d.dot(sun);
                yield aboutSun * (1 + A * StrictMath.exp(B / Math.max(1e-6, height)));
            }
            default -> 1;
        };
    }
}
