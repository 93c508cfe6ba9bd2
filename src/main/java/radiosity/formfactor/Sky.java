package radiosity.formfactor;

import java.util.function.Predicate;
import radiosity.scene.Light;
import radiosity.scene.Vec3;
import radiosity.util.Frame;
import radiosity.util.Hash;

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

    /**
     * Standard deviation of light through random directions, one per cell, times the number of cells along a side, if
     * every cell is seen by half.
     */
    private static final double SPREAD = 0.5;
    /** Largest number of such cells along a side: with more, following edges takes less time. */
    private static final int MOST_CELLS = 48;
    private static final int LEAST_CELLS = 8;
    /** Irradiance from which on random directions do: in a room, their noise is little in the open, but much there. */
    private static final double BRIGHT = 0.2;

    /**
     * How closely a point looks at a sky.
     *
     * @param perRay    irradiance that one ray may carry, relative to that of a level place with a free sky
     * @param tolerance the same relative to the mean irradiance of the scene; at 0 much time may be spent
     * @param key       number from which random directions follow
     */
    record Detail(double perRay, double tolerance, long key) {

        static final Detail EXACT = new Detail(0, 0, 0);
    }

    private final Light light;
    private final Vec3 sun;
    /** Mean luminance over the circle below the hemisphere of a level place with a free sky, in an arbitrary unit. */
    private final double level;

    Sky(Light light) {
        this.light = light;
        sun = light.direction().unit().times(-1);
        level = new SkyView(this, light.up(), d -> true, Detail.EXACT).mean();
    }

    /**
     * Irradiance of a point, relative to that of a level place with a free sky. Where a ray may carry so much that few
     * rays do, and other rays have found much sky, they have random directions: cells with edges that are divided would
     * miss thin bars more often than not.
     *
     * @param n    normal of the point, length 1
     * @param free whether no triangle stands in the way in a direction from the point
     */
    double irradiance(Vec3 n, Predicate<Vec3> free, Detail detail) {
        double cells = Math.max(LEAST_CELLS, Math.ceil(SPREAD / detail.perRay));
        boolean isSampled = cells <= MOST_CELLS
                && sampled(n, free, LEAST_CELLS, Hash.mix(detail.key, -1)) >= BRIGHT * level;
        double mean = isSampled ? sampled(n, free, (int) cells, detail.key)
                : new SkyView(this, n, free, detail).mean();
        return mean / level;
    }

    /** Mean luminance that a point sees, by one random direction in each cell of the square of {@link SkyView}. */
    private double sampled(Vec3 n, Predicate<Vec3> free, int side, long key) {
        Frame frame = Frame.of(n);
        double sum = 0;
        for (int i = 0; i < side * side; i++) {
            double[] local = SkyView.onCircle(random(i / side, side, Hash.mix(key, 2L * i)),
                    random(i % side, side, Hash.mix(key, 2L * i + 1)));
            Vec3 d = frame.vector(local[0], local[1], local[2]);
            double height = d.dot(up());
            sum += height > 0 && free.test(d) ? luminance(d, height) : 0;
        }
        return sum / (side * side);
    }

    /** A coordinate in a cell of the square from -1 to 1. */
    private static double random(int cell, int side, long key) {
        return 2 * (cell + Hash.unit(key)) / side - 1;
    }

    Vec3 up() {
        return light.up();
    }

    /** Luminance in a direction of length 1; a sky of luminance 1 everywhere gives a level place an irradiance of 1. */
    double towards(Vec3 d) {
        double height = d.dot(light.up());
        return height <= 0 ? 0 : luminance(d, height) / level;
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
