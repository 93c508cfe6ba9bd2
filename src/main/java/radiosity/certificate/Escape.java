package radiosity.certificate;

import radiosity.formfactor.PointSequence;
import radiosity.mesh.face.Faces;
import radiosity.visibility.RadiosityBounds;
import radiosity.visibility.Solids;

/**
 * Estimates the part of the light leaving a point that leaves the scene or falls on a back side.
 *
 * <p>Rays are distributed as diffuse light: uniform in the unit circle below the hemisphere (W. Nusselt, Graphische
 * Bestimmung des Winkelverhältnisses bei der Wärmestrahlung, 1928).
 */
final class Escape {

    /** Number of points drawn in the square around the circle; pi/4 of them fall into the circle. */
    private static final int TRIES = 32;
    /** Height above the surface at which a ray begins, and length of a ray, relative to the scene size. */
    private static final float LIFT = 1e-5f;
    private static final float FAR = 4;

    /** About the number of rays at a point. */
    static final int RAYS = 25;

    private final Faces faces;
    private final RadiosityBounds bounds;
    private final float[] front;

    Escape(Faces faces, RadiosityBounds bounds) {
        this.faces = faces;
        this.bounds = bounds;
        front = faces.fronts();
    }

    /**
     * Returns the part of the light leaving a point that arrives nowhere, from 0 to 1.
     *
     * @param place  x, y, z in coordinates of the scene scaled to size 1
     * @param number number of the point; each number has rays of its own
     */
    double from(float[] place, int face, int number) {
        double[] n = {faces.normal(face, 0), faces.normal(face, 1), faces.normal(face, 2)};
        float[] x = new float[3];
        for (int a = 0; a < 3; a++) {
            x[a] = (float) (place[a] + LIFT * n[a]);
        }
        double[] frame = Solids.frame(n[0], n[1], n[2]);
        int all = 0;
        int lost = 0;
        for (int i = 1; i <= TRIES; i++) {
            double p = 2 * PointSequence.u(i + (double) number * TRIES) - 1;
            double q = 2 * PointSequence.v(i + (double) number * TRIES) - 1;
            if (p * p + q * q < 1) {
                all++;
                lost += isLost(x, frame, n, p, q) ? 1 : 0;
            }
        }
        return (double) lost / all;
    }

    private boolean isLost(float[] x, double[] frame, double[] n, double p, double q) {
        double up = Math.sqrt(1 - p * p - q * q);
        float[] d = new float[3];
        for (int a = 0; a < 3; a++) {
            d[a] = (float) (p * frame[a] + q * frame[3 + a] + up * n[a]);
        }
        int t = bounds.nearest(x[0], x[1], x[2], d[0], d[1], d[2], FAR, new float[3]);
        return t < 0 || front[3 * t] * d[0] + front[3 * t + 1] * d[1] + front[3 * t + 2] * d[2] > 0;
    }
}
