package radiosity.formfactor;

import radiosity.util.Hash;
import radiosity.visibility.RadiosityBounds;

/**
 * The paper's own ray casting (section 2.3.2): a form factor is estimated by the integrand of equation 3 at random
 * points of the shooting patch.
 *
 * <p>The integrand has no bound where surfaces meet: a form factor above 1 is scaled down to 1. {@link RayCaster} is
 * more exact with the same number of rays.
 */
final class PlainRays extends PatchByPatch {

    private final int rays;

    /** @param rays number of rays per patch, at least 1 */
    PlainRays(RadiosityBounds bounds, int rays) {
        super(bounds);
        this.rays = rays;
    }

    @Override
    double patch(Receiver to, int node) {
        double factor = 0;
        long random = Hash.mix(to.key(), to.shooter().key[node]);
        for (int i = 0; i < rays; i++) {
            random = Hash.mix(random, i);
            float u = (random >>> 40) * 0x1p-24f;
            float v = (random >>> 16 & 0xFFFFFF) * 0x1p-24f;
            boolean fold = u + v > 1;
            float b = fold ? 1 - u : u;
            float c = fold ? 1 - v : v;
            factor += ray(to, node, 1 - b - c, b, c);
        }
        return factor > 1 ? 1 / factor : 1;
    }

    /**
     * Casts a ray to the point of a patch with corner weights a, b, c.
     *
     * @return cos cos / (pi r^2) times the ray's part of the patch's area (equation 3), also where the point is hidden
     */
    private double ray(Receiver to, int node, float a, float b, float c) {
        ShooterHierarchy s = to.shooter();
        double up = a * to.above(node, 0) + b * to.above(node, 1) + c * to.above(node, 2);
        if (up <= 0) {
            return 0;
        }
        double d2 = 0;
        for (int i = 0; i < 3; i++) {
            double d = a * s.corner[9 * node + i] + b * s.corner[9 * node + 3 + i] + c * s.corner[9 * node + 6 + i]
                    - (i == 0 ? to.px() : i == 1 ? to.py() : to.pz());
            d2 += d * d;
        }
        double factor = up * to.before(node) / (Math.PI * d2 * d2) * s.area[node] / rays;
        addSample(to, node, a, b, c, factor);
        return factor;
    }
}
