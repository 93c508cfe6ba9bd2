package radiosity.util;

import radiosity.scene.Vec3;

/**
 * Three unit vectors at right angles to each other.
 *
 * @param u a tangent of the surface with the normal n
 * @param v the tangent at right angles to u
 */
public record Frame(Vec3 u, Vec3 v, Vec3 n) {

    /** The frame of a unit normal. */
    public static Frame of(Vec3 n) {
        Vec3 u = n.perpendicular();
        return new Frame(u, n.cross(u), n);
    }

    /** The vector with these components along u, v and n. */
    public Vec3 vector(double p, double q, double up) {
        return u.times(p).plus(v.times(q)).plus(n.times(up));
    }

    /**
     * A direction of diffuse light: a point in the unit circle below the hemisphere, raised to the hemisphere
     * (W. Nusselt, Graphische Bestimmung des Winkelverhältnisses bei der Wärmestrahlung, 1928).
     *
     * @param square squared radius of the point, in [0, 1)
     * @param turn   angle of the point, in full turns
     */
    public Vec3 diffuse(double square, double turn) {
        double[] at = inCircle(square, turn);
        return vector(at[0], at[1], Math.sqrt(1 - square));
    }

    /** The two coordinates of a point in the unit circle; points are uniform where both numbers are, in [0, 1). */
    public static double[] inCircle(double square, double turn) {
        double r = Math.sqrt(square);
        double angle = 2 * Math.PI * turn;
        return new double[] {r * StrictMath.cos(angle), r * StrictMath.sin(angle)};
    }
}
