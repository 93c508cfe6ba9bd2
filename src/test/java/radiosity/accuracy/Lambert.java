package radiosity.accuracy;

import java.util.ArrayList;
import java.util.List;
import radiosity.scene.Vec3;

/**
 * The exact configuration factor between a small surface and a polygon, written a second time for the tests and not for
 * speed.
 *
 * <p>J. H. Lambert, Photometria, 1760, as a contour sum: C = 1/(2 pi) sum over edges of Gamma (n . g), Gamma the angle
 * an edge subtends at the point and g the unit normal of the plane of edge and point; the polygon is clipped at the
 * point's horizon.
 */
final class Lambert {

    private Lambert() { }

    /**
     * @param normal  of the small surface, any length
     * @param polygon its corners, in either order
     */
    static double factor(Vec3 point, Vec3 normal, Vec3... polygon) {
        Vec3 n = normal.unit();
        List<Vec3> above = aboveHorizon(point, n, polygon);
        double sum = 0;
        for (int i = 0; i < above.size(); i++) {
            sum += edge(n, above.get(i), above.get((i + 1) % above.size()));
        }
        return Math.abs(sum) / (2 * Math.PI);
    }

    /** The corners of what is above the horizon, as seen from the point. */
    private static List<Vec3> aboveHorizon(Vec3 point, Vec3 n, Vec3... polygon) {
        List<Vec3> kept = new ArrayList<>();
        for (int i = 0; i < polygon.length; i++) {
            Vec3 a = polygon[i].minus(point);
            Vec3 b = polygon[(i + 1) % polygon.length].minus(point);
            double up = n.dot(a);
            double next = n.dot(b);
            if (up >= 0) {
                kept.add(a);
            }
            if (up * next < 0) {
                kept.add(a.plus(b.minus(a).times(up / (up - next))));
            }
        }
        return kept;
    }

    private static double edge(Vec3 n, Vec3 a, Vec3 b) {
        Vec3 cross = a.cross(b);
        return n.dot(cross.unit()) * Math.atan2(cross.length(), a.dot(b));
    }
}
