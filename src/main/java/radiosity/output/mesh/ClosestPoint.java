package radiosity.output.mesh;

import radiosity.scene.Vec3;
import radiosity.solution.Solution;

/**
 * The point of an element or triangle that is nearest to a given point.
 *
 * @param weights  barycentric weights of corners 0, 1 and 2, each at least 0, their sum is 1
 * @param distance from the given point, scene units
 */
public record ClosestPoint(double[] weights, double distance) {

    public ClosestPoint(Solution solution, int element, Vec3 point) {
        this(Elements.corner(solution, element, 0), Elements.corner(solution, element, 1),
                Elements.corner(solution, element, 2), point);
    }

    public ClosestPoint(Vec3 a, Vec3 b, Vec3 c, Vec3 point) {
        this(weights(a, b, c, point), a, b, c, point);
    }

    private ClosestPoint(double[] w, Vec3 a, Vec3 b, Vec3 c, Vec3 point) {
        this(w, a.times(w[0]).plus(b.times(w[1])).plus(c.times(w[2])).minus(point).length());
    }

    /** Barycentric weights of the nearest point: by areas if p projects into the triangle, else on the nearest edge. */
    private static double[] weights(Vec3 a, Vec3 b, Vec3 c, Vec3 p) {
        Vec3 n = b.minus(a).cross(c.minus(a));
        double square = n.dot(n);
        double v = n.dot(a.minus(c).cross(p.minus(c))) / square;
        double w = n.dot(b.minus(a).cross(p.minus(a))) / square;
        if (v >= 0 && w >= 0 && v + w <= 1) {
            return new double[] {1 - v - w, v, w};
        }
        double ab = along(a, b, p);
        double bc = along(b, c, p);
        double ca = along(c, a, p);
        double[][] edges = {{1 - ab, ab, 0}, {0, 1 - bc, bc}, {ca, 0, 1 - ca}};
        double[] nearest = edges[0];
        for (double[] edge : edges) {
            if (new ClosestPoint(edge, a, b, c, p).distance < new ClosestPoint(nearest, a, b, c, p).distance) {
                nearest = edge;
            }
        }
        return nearest;
    }

    /** Fraction in [0, 1] of the edge ab at which its point nearest to p lies; 0 for an edge without length. */
    private static double along(Vec3 a, Vec3 b, Vec3 p) {
        Vec3 d = b.minus(a);
        double square = d.dot(d);
        return square > 0 ? Math.max(0, Math.min(1, d.dot(p.minus(a)) / square)) : 0;
    }
}
