package radiosity.mesh.room;

import radiosity.mesh.face.Faces;

/**
 * Whether a point lies inside a whole shell: the solid angle of the shell, seen from there, is not 0 but -4 pi where
 * the shell's faces look inwards, and 4 pi where they look outwards (A. van Oosterom, J. Strackee, The solid angle of a
 * plane triangle, 1983).
 */
final class SolidAngle {

    /** Number of points of a face for {@link #before}. */
    static final int PLACES = 4;
    /** Distance of such a point from the face, in scene sizes. */
    private static final double BEFORE = Faces.COVERING;

    private SolidAngle() { }

    /** A point a little in front of a face: near corner {@code place}, or before the middle where that is 3. */
    static double[] before(Faces faces, int face, int place) {
        return near(faces, face, place, BEFORE);
    }

    /** A point a little behind a face, see {@link #before}. */
    static double[] behind(Faces faces, int face, int place) {
        return near(faces, face, place, -BEFORE);
    }

    private static double[] near(Faces faces, int face, int place, double height) {
        double[] at = new double[3];
        for (int a = 0; a < 3; a++) {
            for (int k = 0; k < 3; k++) {
                double weight = place == 3 ? 1 / 3.0 : place == k ? 0.9 : 0.05;
                at[a] += weight * faces.corner(face, k, a);
            }
            at[a] += height * faces.normal(face, a);
        }
        return at;
    }

    /** Volume between a face and the origin, in cubed scene sizes; negative where the face looks at the origin. */
    static double volume(Faces faces, int face) {
        return triple(corners(faces, face, 0, 0, 0)) / 6;
    }

    /**
     * Whether a point lies inside a shell that is seen from inside, as the walls of a room are.
     *
     * @param at    x, y, z in the scene brought to size 1; not modified
     * @param walls the faces of a whole shell; not modified
     */
    static boolean isInside(Faces faces, double[] at, int[] walls) {
        return of(faces, at, walls) < -2 * Math.PI;
    }

    /** Whether a point lies inside a shell that is seen from outside, as a solid is, see {@link #isInside}. */
    static boolean isInSolid(Faces faces, double[] at, int[] walls) {
        return of(faces, at, walls) > 2 * Math.PI;
    }

    private static double of(Faces faces, double[] at, int[] walls) {
        double angle = 0;
        for (int f : walls) {
            double[] c = corners(faces, f, at[0], at[1], at[2]);
            double p = length(c, 0);
            double q = length(c, 3);
            double r = length(c, 6);
            double below = p * q * r + dot(c, 0, 3) * r + dot(c, 3, 6) * p + dot(c, 6, 0) * q;
            angle += 2 * StrictMath.atan2(triple(c), below);
        }
        return angle;
    }

    /** Corners of a face relative to a point, 9 numbers. */
    private static double[] corners(Faces faces, int f, double x, double y, double z) {
        double[] c = new double[9];
        for (int i = 0; i < 9; i++) {
            c[i] = faces.corner[9 * f + i] - (i % 3 == 0 ? x : i % 3 == 1 ? y : z);
        }
        return c;
    }

    private static double triple(double[] c) {
        return c[0] * (c[4] * c[8] - c[5] * c[7]) + c[1] * (c[5] * c[6] - c[3] * c[8])
                + c[2] * (c[3] * c[7] - c[4] * c[6]);
    }

    private static double length(double[] c, int i) {
        return Math.sqrt(dot(c, i, i));
    }

    private static double dot(double[] c, int i, int j) {
        return c[i] * c[j] + c[i + 1] * c[j + 1] + c[i + 2] * c[j + 2];
    }
}
