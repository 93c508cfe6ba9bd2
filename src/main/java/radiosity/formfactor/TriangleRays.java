package radiosity.formfactor;

import radiosity.util.R2;

/** Estimates by rays the light that a point receives from a triangle. */
final class TriangleRays {

    /** Largest number of sample points drawn per ray, as points below the receiver's horizon are drawn again. */
    private static final int DRAWS = 64;

    private final ShadowTest sight;

    TriangleRays(ShadowTest sight) {
        this.sight = sight;
    }

    /**
     * Casts rays at a triangle. Each ray goes to one of {@code choices} sample points, chosen with a probability in
     * proportion to K = cos cos / r^2 (J. Talbot, D. Cline, P. Egbert, Importance resampling for global illumination,
     * 2005).
     *
     * @param rotation begins the sequences of sample points and lots: a hash of receiving point and node
     * @param factor   form factor of the whole, unoccluded triangle
     * @param wanted   number of rays
     */
    void sample(float px, float py, float pz, float nx, float ny, float nz, long rotation, double factor,
                        int wanted, int choices, ShooterHierarchy s, int node, GatherSink gathering) {
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
        int lot = R2.lot(rotation);
        double sum = 0;
        int draws = DRAWS * wanted;
        for (int cast = 0; cast < wanted && draws > 0; cast++) {
            double group = 0;
            float b = 0;
            float c = 0;
            for (int drawn = 0; drawn < choices && draws > 0; draws--) {
                u += R2.U;
                v += R2.V;
                int fold = R2.fold(u, v);
                float wb = R2.unit(u ^ fold);
                float wc = R2.unit(v ^ fold);
                float up = upO + wb * upB + wc * upC;
                if (up > 0) {
                    float dx = ox + wb * bx + wc * cx;
                    float dy = oy + wb * by + wc * cy;
                    float dz = oz + wb * bz + wc * cz;
                    double d2 = dx * dx + dy * dy + dz * dz;
                    double k = up / (d2 * d2);
                    group += k;
                    drawn++;
                    lot = R2.next(lot);
                    if (R2.unit(lot) * group < k) {
                        b = wb;
                        c = wc;
                    }
                }
            }
            if (group > 0) {
                float dx = ox + b * bx + c * cx;
                float dy = oy + b * by + c * cy;
                float dz = oz + b * bz + c * cz;
                int seen = sight.sees(px, py, pz, nx, ny, nz, dx, dy, dz, s.normal[3 * node],
                        s.normal[3 * node + 1], s.normal[3 * node + 2]);
                if (seen != 0) {
                    ShadowTest.reach(s, node, 1 - b - c, b, c, seen * group, gathering);
                }
                sum += group;
            }
        }
        gathering.close(sum > 0 ? factor / sum : 0);
    }
}
