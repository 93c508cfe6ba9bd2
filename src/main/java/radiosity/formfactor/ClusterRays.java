package radiosity.formfactor;

import radiosity.util.Hash;
import radiosity.util.R2;

/** Estimates by one ray the light that a point receives from a cluster of triangles. */
final class ClusterRays {

    private static final double BELOW_1 = 0x1.fffffffffffffp-1;

    private final ShadowTest sight;

    ClusterRays(ShadowTest sight) {
        this.sight = sight;
    }

    /**
     * Casts one ray into a cluster. Sample points on {@code draws} triangles are drawn in proportion to the flux that
     * the triangles shoot; one of the points is chosen in proportion to cos cos / r^2, and the ray goes to that point.
     *
     * @param rotation begins the sequences of sample points and lots: a hash of receiving point and cluster
     * @param chance   probability with which this ray was chosen to be cast, in (0, 1]
     */
    void sample(float px, float py, float pz, float nx, float ny, float nz, long rotation, int draws,
                               double chance, ShooterHierarchy s, int cluster, GatherSink gathering) {
        int u = (int) (rotation >>> 32);
        int v = (int) rotation;
        int lot = R2.lot(rotation);
        double pick = Hash.unit(Hash.mix(rotation, 1));
        double sum = 0;
        int found = -1;
        float fb = 0;
        float fc = 0;
        for (int draw = 0; draw < draws; draw++) {
            u += R2.U;
            v += R2.V;
            lot = R2.next(lot);
            int node = pick(s, cluster, Math.min((pick + draw) / draws, BELOW_1));
            int fold = R2.fold(u, v);
            float b = R2.unit(u ^ fold);
            float c = R2.unit(v ^ fold);
            float[] corner = s.corner;
            int at = 9 * node;
            float a = 1 - b - c;
            float dx = a * corner[at] + b * corner[at + 3] + c * corner[at + 6] - px;
            float dy = a * corner[at + 1] + b * corner[at + 4] + c * corner[at + 7] - py;
            float dz = a * corner[at + 2] + b * corner[at + 5] + c * corner[at + 8] - pz;
            double up = nx * dx + ny * dy + nz * dz;
            double down = -(s.normal[3 * node] * dx + s.normal[3 * node + 1] * dy + s.normal[3 * node + 2] * dz);
            if (up <= 0 || down <= ShadowTest.IN_PLANE) {
                continue;
            }
            double d2 = (double) dx * dx + (double) dy * dy + (double) dz * dz;
            double k = up * down / (d2 * d2);
            sum += k;
            if (R2.unit(lot) * sum < k) {
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
        int seen = sight.sees(px, py, pz, nx, ny, nz, tx - px, ty - py, tz - pz, normal[3 * found],
                normal[3 * found + 1], normal[3 * found + 2]);
        if (seen != 0) {
            double power = s.strength[cluster] * s.area[cluster] / s.strength[found];
            ShadowTest.reach(s, found, fa, fb, fc, seen * (power * sum), gathering);
        }
        gathering.close(1 / (draws * Math.PI) / chance);
    }

    /** The triangle at a place in [0, 1) of a cluster, in which each triangle has a part in proportion to its flux. */
    private static int pick(ShooterHierarchy s, int cluster, double place) {
        double x = place;
        int node = cluster;
        while (s.face[node] < 0) {
            int a = s.child[node];
            double share = s.share[node];
            if (x < share) {
                x /= share;
                node = a;
            } else {
                x = Math.min((x - share) / (1 - share), BELOW_1);
                node = a + 1;
            }
        }
        return node;
    }
}
