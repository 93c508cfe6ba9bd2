package radiosity.formfactor;

import radiosity.visibility.RadiosityBounds;

/** What a receiving point sees of a shooter's sample points. */
class ShadowTest {

    /** How far the ends of rays stand off their surfaces at most, of the scene's size. */
    private static final float LIFT = 4e-6f;
    /** Nearer than this to a shooter's plane nothing is received from it; of the scene's size. */
    static final float IN_PLANE = 2e-7f;

    private final RadiosityBounds bounds;

    ShadowTest(RadiosityBounds bounds) {
        this.bounds = bounds;
    }

    /**
     * 1 where nothing stands between a receiving point and a sample point, else 0. Both ends are lifted off their
     * surfaces a little, but by no more than half of what they see of each other's side: a ray that runs almost in a
     * surface would be stopped by that surface itself.
     */
    final int sees(float px, float py, float pz, float nx, float ny, float nz, float dx, float dy, float dz,
                   float sx, float sy, float sz) {
        float up = Math.min(LIFT, 0.5f * (nx * dx + ny * dy + nz * dz));
        float down = Math.min(LIFT, -0.5f * (sx * dx + sy * dy + sz * dz));
        return share(px + up * nx, py + up * ny, pz + up * nz,
                px + dx + down * sx, py + dy + down * sy, pz + dz + down * sz);
    }

    /** What a ray between two points counts for. */
    int share(float ox, float oy, float oz, float tx, float ty, float tz) {
        return bounds.blocked(ox, oy, oz, tx, ty, tz) ? 0 : 1;
    }

    /**
     * Whether rays from a point into a sphere may count.
     *
     * @param sphere middle, and squared radius, 4 from {@code at}
     */
    boolean matters(float px, float py, float pz, float[] sphere, int at) {
        return true;
    }

    /** Finds the element under a sample point. */
    static void reach(ShooterHierarchy s, int node, float wa, float wb, float wc, double k, GatherSink gathering) {
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
