package radiosity.formfactor;

import radiosity.visibility.RadiosityBounds;

/** Visibility between a receiving point and sample points of a shooter. */
class ShadowTest {

    /** Largest distance of a ray's ends from their surfaces, in units of the scene's size. */
    private static final float LIFT = 4e-6f;
    /** Height above a shooter's plane, in units of the scene's size, up to which a point receives nothing from it. */
    static final float IN_PLANE = 2e-7f;

    private static final int HALF = Float.floatToRawIntBits(0.5f);

    private final RadiosityBounds bounds;

    ShadowTest(RadiosityBounds bounds) {
        this.bounds = bounds;
    }

    /**
     * {@link #share} of the ray from receiving point p with normal n to the sample point p + d with normal s. Both ends
     * are lifted off their surfaces, else the surfaces themselves would stop the ray; each end by no more than half of
     * the height at which the other end lies above this end's surface.
     */
    final int sees(float px, float py, float pz, float nx, float ny, float nz, float dx, float dy, float dz,
                   float sx, float sy, float sz) {
        float up = Math.min(LIFT, 0.5f * (nx * dx + ny * dy + nz * dz));
        float down = Math.min(LIFT, -0.5f * (sx * dx + sy * dy + sz * dz));
        return share(px + up * nx, py + up * ny, pz + up * nz,
                px + dx + down * sx, py + dy + down * sy, pz + dz + down * sz);
    }

    /** Visibility of a ray from o to t: 1 where no triangle stands between the points, else 0. */
    int share(float ox, float oy, float oz, float tx, float ty, float tz) {
        return bounds.blocked(ox, oy, oz, tx, ty, tz) ? 0 : 1;
    }

    /**
     * Whether {@link #share} may be other than 0 for rays from a point into a sphere.
     *
     * @param sphere middle and squared radius, 4 numbers from {@code at}; not modified
     */
    boolean matters(float px, float py, float pz, float[] sphere, int at) {
        return true;
    }

    /** Adds to the sink the element that contains a sample point of a node with corner weights wa, wb, wc, times k. */
    static void reach(ShooterHierarchy s, int node, float wa, float wb, float wc, double k, GatherSink gathering) {
        int[] child = s.child;
        float a = wa;
        float b = wb;
        float c = wc;
        int leaf = node;
        for (int first = child[leaf]; first >= 0; first = child[leaf]) {
            int atA = isAboveHalf(a);
            int atB = isAboveHalf(b);
            int atC = isAboveHalf(c);
            int middle = 1 - atA - atB - atC;
            float sign = 1 - 2 * middle;
            a = sign * (2 * a) + (middle - atA);
            b = sign * (2 * b) + (middle - atB);
            c = sign * (2 * c) + (middle - atC);
            leaf = first + atB + 2 * atC + 3 * middle;
        }
        gathering.add(s, leaf, a * k, b * k, c * k);
    }

    /** 1 where a number above -1 is above 0.5, else 0; without a branch, which a processor could not predict. */
    private static int isAboveHalf(float x) {
        return (int) (((long) HALF - Float.floatToRawIntBits(x)) >>> 63);
    }
}
