package radiosity.formfactor;

import java.util.Arrays;
import java.util.List;
import radiosity.mesh.InteriorTest;
import radiosity.mesh.PatchTree;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.Subdivision;
import radiosity.util.Frame;
import radiosity.util.Hash;
import radiosity.util.R2;
import radiosity.visibility.RadiosityBounds;
import radiosity.visibility.Solids;

/**
 * Finds by rays how much of the light that leaves surfaces arrives nowhere: it leaves the scene, falls on a back side,
 * or falls on a place inside a solid, where no vertex receives.
 *
 * <p>Rays are distributed as diffuse light: uniform in the unit circle below the hemisphere (W. Nusselt, Graphische
 * Bestimmung des Winkelverhältnisses bei der Wärmestrahlung, 1928).
 */
public final class EscapingLight {

    private static final float LIFT = (float) RadiosityBounds.LIFT;
    /** Number of points drawn in the square around the circle; pi/4 of them fall into the circle. */
    private static final int TRIES = 32;
    /** About the number of rays with which {@link #share} is estimated. */
    public static final int RAYS = 25;
    /** Random points that are tried on a partly covered element. */
    private static final int MOST_TRIES = 20;

    private final Faces faces;
    private final RadiosityBounds bounds;
    private final Solids solids;
    private final InteriorTest interior;

    public EscapingLight(Faces faces, RadiosityBounds bounds, Solids solids, InteriorTest interior) {
        this.faces = faces;
        this.bounds = bounds;
        this.solids = solids;
        this.interior = interior;
    }

    /**
     * Whether the light that leaves a point in one direction arrives nowhere.
     *
     * @param place x, y, z in coordinates of the scene scaled to size 1
     * @param p     with {@code q}: point in the unit circle below the hemisphere; p² + q² < 1
     */
    public boolean escapes(float[] place, int face, double p, double q) {
        float[] x = new float[3];
        for (int a = 0; a < 3; a++) {
            x[a] = (float) (place[a] + LIFT * (double) faces.normal(face, a));
        }
        return arrival(x, Solids.direction(p, q, faces.unitNormal(face)), new float[3]) < 0;
    }

    /**
     * Estimates the part of the light leaving a point that arrives nowhere, from 0 to 1.
     *
     * @param place  x, y, z in coordinates of the scene scaled to size 1
     * @param number number of the point; each number has rays of its own
     */
    public double share(float[] place, int face, int number) {
        int all = 0;
        int lost = 0;
        for (int i = 1; i <= TRIES; i++) {
            double p = 2 * R2.u(i + (double) number * TRIES) - 1;
            double q = 2 * R2.v(i + (double) number * TRIES) - 1;
            if (p * p + q * q < 1) {
                all++;
                lost += escapes(place, face, p, q) ? 1 : 0;
            }
        }
        return (double) lost / all;
    }

    /**
     * The triangle on whose visible side a ray arrives; -1 where the ray arrives nowhere.
     *
     * @param x   origin, in coordinates of the scene scaled to size 1; not modified
     * @param d   direction, of length 1; not modified
     * @param hit modified: see {@link RadiosityBounds#nearestFront}
     */
    int arrival(float[] x, float[] d, float[] hit) {
        int t = bounds.nearestFront(x[0], x[1], x[2], d[0], d[1], d[2], RadiosityBounds.ACROSS, true, hit);
        return t < 0 || solids.leaves(t, d) || solids.hold(t, x, d, hit[0]) ? -1 : t;
    }

    /**
     * Estimates how much of the light that leaves some elements escapes: by rays in proportion to the flux of each
     * element, from random points and in random directions that are the same for the same light.
     *
     * @param trees  elements and their radiosities, which may be negative
     * @param perRay sum over channels of the |flux| for which one ray stands, W/m² times squared scene size; above 0
     * @return per channel the signed flux that escapes, then per channel the variance of that estimate
     */
    public double[] flux(List<PatchTree> trees, double perRay) {
        double[] sum = new double[2 * faces.channels()];
        for (PatchTree tree : trees) {
            float[] at = faces.corners(tree.face(), tree.path());
            double area = faces.exposedArea(tree.face(), tree.path());
            add(tree, 0, at, area, Hash.mix(tree.face(), tree.path()), perRay, sum);
        }
        return sum;
    }

    private void add(PatchTree tree, int node, float[] at, double area, long key, double perRay, double[] sum) {
        int first = tree.child()[node];
        if (first < 0) {
            add(Arrays.copyOfRange(tree.radiosity(), 3 * faces.channels() * node, 3 * faces.channels() * (node + 1)),
                    tree.face(), at, area, key, perRay, sum);
            return;
        }
        for (int k = 0; k < 4; k++) {
            float[] below = new float[9];
            Subdivision.child(at, 0, k, below, 0);
            add(tree, first + k, below, area / 4, Hash.mix(key, k), perRay, sum);
        }
    }

    /** @param radiosity per corner one value per channel, W/m² */
    private void add(double[] radiosity, int face, float[] at, double area, long key, double perRay, double[] sum) {
        int channels = faces.channels();
        double all = 0;
        for (double corner : radiosity) {
            all += Math.abs(corner) * area / 3;
        }
        double rays = all / perRay;
        int whole = (int) (rays + Hash.unit(Hash.mix(key, 0)));
        for (int i = 1; i <= whole; i++) {
            double[] weight = point(face, at, Hash.mix(key, 4L * i));
            float[] place = place(at, weight);
            double[] d = Frame.inCircle(Hash.unit(Hash.mix(key, 4L * i + 2)), Hash.unit(Hash.mix(key, 4L * i + 3)));
            if (escapes(place, face, d[0], d[1])) {
                for (int c = 0; c < channels; c++) {
                    double flux = area / rays * (weight[0] * radiosity[c] + weight[1] * radiosity[channels + c]
                            + weight[2] * radiosity[2 * channels + c]);
                    sum[c] += flux;
                    sum[channels + c] += flux * flux;
                }
            }
        }
    }

    /** Weights of the corners at a random point of a triangle, outside of what hides a part of the face. */
    private double[] point(int face, float[] at, long key) {
        boolean isPartlyCovered = faces.exposedArea(face) < faces.area(face);
        double[] weight;
        int tries = 0;
        do {
            double u = Hash.unit(Hash.mix(key, 2L * tries));
            double v = Hash.unit(Hash.mix(key, 2L * tries + 1));
            boolean isBeyond = u + v > 1;
            weight = new double[] {isBeyond ? u + v - 1 : 1 - u - v, isBeyond ? 1 - u : u, isBeyond ? 1 - v : v};
            tries++;
        } while (isPartlyCovered && tries < MOST_TRIES && interior.isBuried(place(at, weight), 0, face));
        return weight;
    }

    private static float[] place(float[] at, double[] weight) {
        float[] place = new float[3];
        for (int a = 0; a < 3; a++) {
            place[a] = (float) (weight[0] * at[a] + weight[1] * at[3 + a] + weight[2] * at[6 + a]);
        }
        return place;
    }
}
