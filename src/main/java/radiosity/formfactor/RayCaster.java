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
    private static final int R2_U = 0xC13FA9A9;
    private static final int R2_V = 0x91E10DA6;
    /** Sample points below the receiver's horizon are drawn again, so often per ray. */
    private static final int DRAWS = 64;
    /** By how much what is near counts for more: kernel and shadows change faster over it. */
    private static final double NEAR = 16;
    /** Squared size over squared distance from which 8, and from which 4 sample points are drawn per ray. */
    private static final double NEAR_8 = 0.05;
    private static final double NEAR_4 = 0.003;
    /** Triangles drawn for one ray from a cluster that carries as much as a ray may; in proportion from others. */
    private static final int CLUSTER_DRAWS = 8;
    /** How far the ends of rays stand off their surfaces at most, of the scene's size. */
    private static final float LIFT = 4e-6f;
    /** Rays at one element. */
    private static final int MOST_RAYS = 64;
    /** Nearer than this to a shooter's plane nothing is received from it; of the scene's size. */
    private static final float IN_PLANE = 2e-7f;

    private final RadiosityBounds bounds;
    private final int rays;
    private final double tolerance;
    private final int mostRays;

    /**
     * @param rays      sample points per shooting node, at least 1
     * @param tolerance what those may carry together before the node is entered, or cast more rays at if it is an
     *                  element: form factor times {@link Shooter}'s strength; infinite: no node is entered
     */
    public RayCaster(RadiosityBounds bounds, int rays, double tolerance) {
        this(bounds, rays, tolerance, Math.max(rays, MOST_RAYS));
    }

    /** @param mostRays no more are cast at one element, whatever it carries */
    public RayCaster(RadiosityBounds bounds, int rays, double tolerance, int mostRays) {
        this.bounds = bounds;
        this.rays = rays;
        this.tolerance = tolerance;
        this.mostRays = mostRays;
    }

    @Override
    public void gather(float px, float py, float pz, float nx, float ny, float nz, long key, Shooter shooter,
                       Gathering gathering) {
        enter(px, py, pz, nx, ny, nz, key, shooter, 0, gathering);
    }

    private void enter(float px, float py, float pz, float nx, float ny, float nz, long key, Shooter s, int node,
                       Gathering gathering) {
        double strength = s.strength[node];
        float[] extent = s.extent;
        float ex = extent[4 * node] - px;
        float ey = extent[4 * node + 1] - py;
        float ez = extent[4 * node + 2] - pz;
        float r2 = extent[4 * node + 3];
        float up = nx * ex + ny * ey + nz * ez;
        if (strength == 0 || up < 0 && up * up >= r2) {
            return;
        }
        float d2 = ex * ex + ey * ey + ez * ez;
        if (s.face[node] < 0) {
            double gap = Math.sqrt(d2) - Math.sqrt(r2);
            double most = strength * s.area[node] * (1 + NEAR * r2 / d2);
            double may = tolerance * Math.PI * gap * gap;
            if (gap > 0 && most <= may) {
                int draws = (int) Math.ceil(CLUSTER_DRAWS * most / may);
                sampleCluster(px, py, pz, nx, ny, nz, Hash.mix(key, s.key[node]), draws, s, node, gathering);
            } else {
                enter(px, py, pz, nx, ny, nz, key, s, s.child[node], gathering);
                enter(px, py, pz, nx, ny, nz, key, s, s.child[node] + 1, gathering);
            }
            return;
        }
        float above = -(s.normal[3 * node] * ex + s.normal[3 * node + 1] * ey + s.normal[3 * node + 2] * ez);
        if (above <= IN_PLANE) {
            return;
        }
        double factor = ContourFactor.triangle(px, py, pz, nx, ny, nz, s.corner, 9 * node);
        if (factor <= 0) {
            return;
        }
        float near = r2 / d2;
        double carried = factor * strength * (1 + NEAR * near);
        int first = s.child[node];
        if (first >= 0 && carried > tolerance) {
            for (int k = 0; k < 4; k++) {
                enter(px, py, pz, nx, ny, nz, key, s, first + k, gathering);
            }
            return;
        }
        int wanted = carried > tolerance ? (int) Math.min(mostRays, rays * Math.ceil(carried / tolerance)) : rays;
        int choices = near > NEAR_8 ? Math.max(1, 8 / wanted) : near > NEAR_4 ? Math.max(1, 4 / wanted) : 1;
        sample(px, py, pz, nx, ny, nz, Hash.mix(key, s.key[node]), factor, wanted, choices, s, node, gathering);
    }

    /**
     * One ray into a cluster of triangles: a few of them are drawn in proportion to what they shoot, and of these one
     * in proportion to how it stands.
     */
    private void sampleCluster(float px, float py, float pz, float nx, float ny, float nz, long rotation, int draws,
                               Shooter s, int cluster, Gathering gathering) {
        int u = (int) (rotation >>> 32);
        int v = (int) rotation;
        int lot = lot(rotation);
        double pick = (Hash.mix(rotation, 1) >>> 11) * 0x1p-53;
        double sum = 0;
        int found = -1;
        float fb = 0;
        float fc = 0;
        for (int draw = 0; draw < draws; draw++) {
            u += R2_U;
            v += R2_V;
            lot = next(lot);
            int node = pick(s, cluster, (pick + draw) / draws);
            int fold = fold(u, v);
            float b = unit(u ^ fold);
            float c = unit(v ^ fold);
            float[] corner = s.corner;
            int at = 9 * node;
            float a = 1 - b - c;
            float dx = a * corner[at] + b * corner[at + 3] + c * corner[at + 6] - px;
            float dy = a * corner[at + 1] + b * corner[at + 4] + c * corner[at + 7] - py;
            float dz = a * corner[at + 2] + b * corner[at + 5] + c * corner[at + 8] - pz;
            double up = nx * dx + ny * dy + nz * dz;
            double down = -(s.normal[3 * node] * dx + s.normal[3 * node + 1] * dy + s.normal[3 * node + 2] * dz);
            if (up <= 0 || down <= IN_PLANE) {
                continue;
            }
            double d2 = (double) dx * dx + (double) dy * dy + (double) dz * dz;
            double k = up * down / (d2 * d2);
            sum += k;
            if (unit(lot) * sum < k) {
                found = node;
                fb = b;
                fc = c;
            }
        }
        if (found < 0) {
            return;
        }
        float[] corner = s.corner;
        int at = 9 * found;
        float fa = 1 - fb - fc;
        float tx = fa * corner[at] + fb * corner[at + 3] + fc * corner[at + 6];
        float ty = fa * corner[at + 1] + fb * corner[at + 4] + fc * corner[at + 7];
        float tz = fa * corner[at + 2] + fb * corner[at + 5] + fc * corner[at + 8];
        float[] normal = s.normal;
        if (sees(px, py, pz, nx, ny, nz, tx - px, ty - py, tz - pz, normal[3 * found], normal[3 * found + 1],
                normal[3 * found + 2])) {
            double power = s.strength[cluster] * s.area[cluster] / s.strength[found];
            reach(s, found, fa, fb, fc, power * sum, gathering);
        }
        gathering.close(1 / (draws * Math.PI));
    }

    /** The triangle at a place in [0, 1) of a cluster, where each takes as much room as it shoots. */
    private static int pick(Shooter s, int cluster, double place) {
        double x = place;
        int node = cluster;
        while (s.face[node] < 0) {
            int a = s.child[node];
            double share = s.share[node];
            if (x < share) {
                x /= share;
                node = a;
            } else {
                x = Math.min((x - share) / (1 - share), 0x1.fffffffffffffp-1);
                node = a + 1;
            }
        }
        return node;
    }

    /**
     * Each ray goes to one of a few sample points, chosen with probability K: what is near counts for more, and counts
     * so without a ray to each point (J. Talbot, D. Cline, P. Egbert, Importance resampling for global illumination,
     * 2005).
     */
    private void sample(float px, float py, float pz, float nx, float ny, float nz, long rotation, double factor,
                        int wanted, int choices, Shooter s, int node, Gathering gathering) {
        float[] corner = s.corner;
        int at = 9 * node;
        float ox = corner[at] - px;
        float oy = corner[at + 1] - py;
        float oz = corner[at + 2] - pz;
        float bx = corner[at + 3] - corner[at];
        float by = corner[at + 4] - corner[at + 1];
        float bz = corner[at + 5] - corner[at + 2];
        float cx = corner[at + 6] - corner[at];
        float cy = corner[at + 7] - corner[at + 1];
        float cz = corner[at + 8] - corner[at + 2];
        float upO = nx * ox + ny * oy + nz * oz;
        float upB = nx * bx + ny * by + nz * bz;
        float upC = nx * cx + ny * cy + nz * cz;
        int u = (int) (rotation >>> 32);
        int v = (int) rotation;
        int lot = lot(rotation);
        double sum = 0;
        int draws = DRAWS * wanted;
        for (int cast = 0; cast < wanted && draws > 0; cast++) {
            double group = 0;
            float b = 0;
            float c = 0;
            for (int drawn = 0; drawn < choices && draws > 0; draws--) {
                u += R2_U;
                v += R2_V;
                int fold = fold(u, v);
                float wb = unit(u ^ fold);
                float wc = unit(v ^ fold);
                float up = upO + wb * upB + wc * upC;
                if (up > 0) {
                    float dx = ox + wb * bx + wc * cx;
                    float dy = oy + wb * by + wc * cy;
                    float dz = oz + wb * bz + wc * cz;
                    double d2 = dx * dx + dy * dy + dz * dz;
                    double k = up / (d2 * d2);
                    group += k;
                    drawn++;
                    lot = next(lot);
                    if (unit(lot) * group < k) {
                        b = wb;
                        c = wc;
                    }
                }
            }
            if (group > 0) {
                float dx = ox + b * bx + c * cx;
                float dy = oy + b * by + c * cy;
                float dz = oz + b * bz + c * cz;
                if (sees(px, py, pz, nx, ny, nz, dx, dy, dz, s.normal[3 * node], s.normal[3 * node + 1],
                        s.normal[3 * node + 2])) {
                    reach(s, node, 1 - b - c, b, c, group, gathering);
                }
                sum += group;
            }
        }
        gathering.close(sum > 0 ? factor / sum : 0);
    }

    /** A number in [0, 1) of 24 bits. */
    private static float unit(int bits) {
        return (bits >>> 8) * 0x1p-24f;
    }

    /** What turns a point of the unit square beyond its diagonal back into the triangle; without a branch. */
    private static int fold(int u, int v) {
        return -((u >>> 8) + (v >>> 8) >>> 24);
    }

    /** Where a sequence of lots begins. */
    private static int lot(long rotation) {
        return (int) (rotation * 0x9E3779B97F4A7C15L >>> 32);
    }

    /** The lot after one. Source: W. Press and others, Numerical Recipes, 1992, 7.1. */
    private static int next(int lot) {
        return lot * 1664525 + 1013904223;
    }

    /**
     * Whether nothing stands between a receiving point and a sample point. Both ends are lifted off their surfaces a
     * little, but by no more than half of what they see of each other's side: a ray that runs almost in a surface
     * would be stopped by that surface itself.
     */
    boolean sees(float px, float py, float pz, float nx, float ny, float nz, float dx, float dy, float dz,
                         float sx, float sy, float sz) {
        float up = Math.min(LIFT, 0.5f * (nx * dx + ny * dy + nz * dz));
        float down = Math.min(LIFT, -0.5f * (sx * dx + sy * dy + sz * dz));
        return !bounds.blocked(px + up * nx, py + up * ny, pz + up * nz,
                px + dx + down * sx, py + dy + down * sy, pz + dz + down * sz);
    }

    /** Finds the element under a sample point. */
    static void reach(Shooter s, int node, float wa, float wb, float wc, double k, Gathering gathering) {
        float a = wa;
        float b = wb;
        float c = wc;
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
        gathering.add(s, leaf, a * k, b * k, c * k);
    }
}
