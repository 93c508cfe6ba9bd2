package radiosity.formfactor;

import radiosity.patch.Hash;
import radiosity.visibility.RadiosityBounds;

/**
 * Form factors by ray casting (section 2.3.2 and 4.5.11 of the paper): the exact factor to the shooter times the share
 * of it that is visible, by rays to sample points.
 *
 * <p>A shooter whose light is too much for so few rays is entered: its four parts are treated one by one, down to its
 * elements.
 */
public final class RayCaster implements FormFactorCalculator {

    /*
     * Share: sum V K / sum K over the sample points, K = cos cos / r^2. The paper's kernel K A / pi alone loses up to
     * 90 % near a surface; see docs/DECISIONS.md. Sample points are those of the R2 sequence (M. Roberts, The
     * unreasonable effectiveness of quasirandom sequences, 2018), rotated by a hash of receiving point and shooting
     * node: the same ray is cast whoever casts it.
     */
    private static final double R2_U = 0.7548776662466927;
    private static final double R2_V = 0.5698402909980532;
    /** Sample points below the receiver's horizon are drawn again, so often per ray. */
    private static final int DRAWS = 16;
    /** Nearer than this to a shooter's plane nothing is received from it; of the scene's size. */
    private static final float IN_PLANE = 2e-7f;

    private final RadiosityBounds bounds;
    private final int rays;
    private final double tolerance;

    /**
     * @param rays      sample points per shooting node, at least 1
     * @param tolerance irradiance that those may carry together before the node is entered, W/m²; infinite: no node is
     */
    public RayCaster(RadiosityBounds bounds, int rays, double tolerance) {
        this.bounds = bounds;
        this.rays = rays;
        this.tolerance = tolerance;
    }

    @Override
    public void gather(float px, float py, float pz, float nx, float ny, float nz, long key, Shooter shooter,
                       double[] irradiance) {
        float[] corner = shooter.corner;
        float above = shooter.nx * (px - corner[0]) + shooter.ny * (py - corner[1]) + shooter.nz * (pz - corner[2]);
        if (above > IN_PLANE) {
            enter(px, py, pz, nx, ny, nz, key, shooter, 0, irradiance);
        }
    }

    private void enter(float px, float py, float pz, float nx, float ny, float nz, long key, Shooter shooter,
                       int node, double[] irradiance) {
        double strength = shooter.strength[node];
        if (strength == 0) {
            return;
        }
        double factor = ContourFactor.triangle(px, py, pz, nx, ny, nz, shooter.corner, 9 * node);
        if (factor <= 0) {
            return;
        }
        int first = shooter.child[node];
        if (first >= 0 && factor * strength > tolerance) {
            for (int k = 0; k < 4; k++) {
                enter(px, py, pz, nx, ny, nz, key, shooter, first + k, irradiance);
            }
            return;
        }
        sample(px, py, pz, nx, ny, nz, Hash.mix(key, shooter.key[node]), factor, shooter, node, irradiance);
    }

    private void sample(float px, float py, float pz, float nx, float ny, float nz, long rotation, double factor,
                        Shooter s, int node, double[] irradiance) {
        float[] corner = s.corner;
        int at = 9 * node;
        int channels = s.channels;
        double u = (rotation >>> 40) * 0x1p-24;
        double v = (rotation >>> 16 & 0xFFFFFF) * 0x1p-24;
        double sumK = 0;
        double sum0 = 0;
        double sum1 = 0;
        double sum2 = 0;
        int cast = 0;
        for (int draw = 0; cast < rays && draw < DRAWS * rays; draw++) {
            u += R2_U;
            u -= (int) u;
            v += R2_V;
            v -= (int) v;
            boolean fold = u + v > 1;
            float b = (float) (fold ? 1 - u : u);
            float c = (float) (fold ? 1 - v : v);
            float a = 1 - b - c;
            float tx = a * corner[at] + b * corner[at + 3] + c * corner[at + 6];
            float ty = a * corner[at + 1] + b * corner[at + 4] + c * corner[at + 7];
            float tz = a * corner[at + 2] + b * corner[at + 5] + c * corner[at + 8];
            float dx = tx - px;
            float dy = ty - py;
            float dz = tz - pz;
            float up = nx * dx + ny * dy + nz * dz;
            if (up <= 0) {
                continue;
            }
            cast++;
            float d2 = dx * dx + dy * dy + dz * dz;
            double k = -(double) up * (s.nx * dx + s.ny * dy + s.nz * dz) / ((double) d2 * d2);
            sumK += k;
            if (bounds.blocked(px, py, pz, tx, ty, tz)) {
                continue;
            }
            int leaf = node;
            while (s.child[leaf] >= 0) {
                int step = a > 0.5f ? 0 : b > 0.5f ? 1 : c > 0.5f ? 2 : 3;
                if (step == 3) {
                    a = 1 - 2 * a;
                    b = 1 - 2 * b;
                    c = 1 - 2 * c;
                } else {
                    a = step == 0 ? 2 * a - 1 : 2 * a;
                    b = step == 1 ? 2 * b - 1 : 2 * b;
                    c = step == 2 ? 2 * c - 1 : 2 * c;
                }
                leaf = s.child[leaf] + step;
            }
            int r = 3 * channels * leaf;
            sum0 += k * (a * s.radiosity[r] + b * s.radiosity[r + channels] + c * s.radiosity[r + 2 * channels]);
            if (channels == 3) {
                sum1 += k * (a * s.radiosity[r + 1] + b * s.radiosity[r + 4] + c * s.radiosity[r + 7]);
                sum2 += k * (a * s.radiosity[r + 2] + b * s.radiosity[r + 5] + c * s.radiosity[r + 8]);
            }
        }
        if (sumK > 0) {
            double scale = factor / sumK;
            irradiance[0] += scale * sum0;
            if (channels == 3) {
                irradiance[1] += scale * sum1;
                irradiance[2] += scale * sum2;
            }
        }
    }
}
