package radiosity.formfactor;

import java.util.ArrayList;
import java.util.List;
import radiosity.scene.Vec3;
import radiosity.util.ArcTangent;

/**
 * The exact form factor from a point to an unoccluded polygon: the irradiance at the point divided by the irradiance
 * that the point would have if the polygon filled its whole hemisphere.
 *
 * <p>Source: J. H. Lambert, Photometria, 1760; as a contour sum D. R. Baum, H. E. Rushmeier, J. M. Winget, Improving
 * radiosity solutions through the use of analytically determined form-factors, 1989: F = 1/(2 pi) sum over edges of
 * the angle that the edge subtends times the cosine between the receiver's normal and the normal of the plane through
 * point and edge. The part of the polygon below the receiver's horizon is cut off.
 */
public final class ContourFactor {

    private static final double HALF_OVER_PI = 0.5 / Math.PI;

    private ContourFactor() { }

    /**
     * The form factor to a plane polygon, convex or not.
     *
     * @param x       the receiving point
     * @param n       its normal, length 1
     * @param polygon corners, counter-clockwise as seen from its visible side; not modified
     * @return form factor in [0, 1]; 0 for a point behind the polygon
     */
    public static double factor(Vec3 x, Vec3 n, Vec3... polygon) {
        List<Vec3> cut = new ArrayList<>();
        for (int i = 0; i < polygon.length; i++) {
            Vec3 a = polygon[i].minus(x);
            Vec3 b = polygon[(i + 1) % polygon.length].minus(x);
            double up = n.dot(a);
            double next = n.dot(b);
            if (up >= 0) {
                cut.add(a);
            }
            if (up > 0 && next < 0 || up < 0 && next > 0) {
                cut.add(a.plus(b.minus(a).times(up / (up - next))));
            }
        }
        double sum = 0;
        for (int i = 0; i < cut.size(); i++) {
            Vec3 a = cut.get(i);
            Vec3 b = cut.get((i + 1) % cut.size());
            sum += edge(n.x(), n.y(), n.z(), a.x(), a.y(), a.z(), b.x(), b.y(), b.z());
        }
        return Math.min(1, Math.max(0, -sum * HALF_OVER_PI));
    }

    /** Angle between a and b times the cosine between n and a x b; 0 where the point lies on the edge. */
    private static double edge(double nx, double ny, double nz,
                               double ax, double ay, double az, double bx, double by, double bz) {
        double cx = ay * bz - az * by;
        double cy = az * bx - ax * bz;
        double cz = ax * by - ay * bx;
        double up = nx * cx + ny * cy + nz * cz;
        double sine = Math.sqrt(cx * cx + cy * cy + cz * cz);
        double cosine = ax * bx + ay * by + az * bz;
        if (sine == 0 && cosine <= 0) {
            return 0;
        }
        return up * ArcTangent.overSine(sine, cosine);
    }

    /**
     * The form factor to a triangle.
     *
     * @param corner x, y, z of three corners, 9 numbers from {@code i}; not modified
     */
    static double triangle(double px, double py, double pz, double nx, double ny, double nz, float[] corner, int i) {
        double ax = corner[i] - px;
        double ay = corner[i + 1] - py;
        double az = corner[i + 2] - pz;
        double bx = corner[i + 3] - px;
        double by = corner[i + 4] - py;
        double bz = corner[i + 5] - pz;
        double cx = corner[i + 6] - px;
        double cy = corner[i + 7] - py;
        double cz = corner[i + 8] - pz;
        double ua = nx * ax + ny * ay + nz * az;
        double ub = nx * bx + ny * by + nz * bz;
        double uc = nx * cx + ny * cy + nz * cz;
        if (ua <= 0 && ub <= 0 && uc <= 0) {
            return 0;
        }
        double sum;
        if (ua >= 0 && ub >= 0 && uc >= 0) {
            sum = edge(nx, ny, nz, ax, ay, az, bx, by, bz) + edge(nx, ny, nz, bx, by, bz, cx, cy, cz)
                    + edge(nx, ny, nz, cx, cy, cz, ax, ay, az);
        } else {
            sum = cut(nx, ny, nz, ax, ay, az, bx, by, bz, cx, cy, cz, ua, ub, uc);
        }
        return Math.max(0, -sum * HALF_OVER_PI);
    }

    /** Contour sum of a triangle across the horizon: rotates its corners until a is alone on a side of the horizon. */
    private static double cut(double nx, double ny, double nz, double ax, double ay, double az,
                              double bx, double by, double bz, double cx, double cy, double cz,
                              double ua, double ub, double uc) {
        boolean a = ua > 0;
        boolean b = ub > 0;
        boolean c = uc > 0;
        if (b == c) {
            return lone(nx, ny, nz, ax, ay, az, bx, by, bz, cx, cy, cz, ua, ub, uc);
        }
        return a == c ? lone(nx, ny, nz, bx, by, bz, cx, cy, cz, ax, ay, az, ub, uc, ua)
                : lone(nx, ny, nz, cx, cy, cz, ax, ay, az, bx, by, bz, uc, ua, ub);
    }

    /** Contour sum of the part above the horizon, where corner a is alone on its side, above or below. */
    private static double lone(double nx, double ny, double nz, double ax, double ay, double az,
                               double bx, double by, double bz, double cx, double cy, double cz,
                               double ua, double ub, double uc) {
        double s = ua / (ua - ub);
        double t = ua / (ua - uc);
        double px = ax + s * (bx - ax);
        double py = ay + s * (by - ay);
        double pz = az + s * (bz - az);
        double qx = ax + t * (cx - ax);
        double qy = ay + t * (cy - ay);
        double qz = az + t * (cz - az);
        if (ua > 0) {
            return edge(nx, ny, nz, ax, ay, az, px, py, pz) + edge(nx, ny, nz, px, py, pz, qx, qy, qz)
                    + edge(nx, ny, nz, qx, qy, qz, ax, ay, az);
        }
        return edge(nx, ny, nz, px, py, pz, bx, by, bz) + edge(nx, ny, nz, bx, by, bz, cx, cy, cz)
                + edge(nx, ny, nz, cx, cy, cz, qx, qy, qz) + edge(nx, ny, nz, qx, qy, qz, px, py, pz);
    }
}
