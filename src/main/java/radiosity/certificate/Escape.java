package radiosity.certificate;

import radiosity.formfactor.EscapingLight;
import radiosity.mesh.face.Faces;
import radiosity.util.R2;
import radiosity.visibility.RadiosityBounds;

/** Estimates the part of the light leaving a point that arrives nowhere, see {@link EscapingLight}. */
final class Escape {

    /** Number of points drawn in the square around the circle; pi/4 of them fall into the circle. */
    private static final int TRIES = 32;
    /** About the number of rays at a point. */
    static final int RAYS = 25;

    private final EscapingLight light;

    Escape(Faces faces, RadiosityBounds bounds) {
        light = new EscapingLight(faces, bounds);
    }

    /**
     * Returns the part of the light leaving a point that arrives nowhere, from 0 to 1.
     *
     * @param place  x, y, z in coordinates of the scene scaled to size 1
     * @param number number of the point; each number has rays of its own
     */
    double from(float[] place, int face, int number) {
        int all = 0;
        int lost = 0;
        for (int i = 1; i <= TRIES; i++) {
            double p = 2 * R2.u(i + (double) number * TRIES) - 1;
            double q = 2 * R2.v(i + (double) number * TRIES) - 1;
            if (p * p + q * q < 1) {
                all++;
                lost += light.escapes(place, face, p, q) ? 1 : 0;
            }
        }
        return (double) lost / all;
    }
}
