package radiosity.testkit;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import radiosity.scene.Vec3;

/**
 * Integrals over polygons of functions that may be singular along their edges: H. Takahasi and M. Mori, Double
 * exponential formulas for numerical integration, 1974, in both directions of every triangle of the polygon.
 */
public final class Quadrature {

    private static final double STEP = 0.06;
    private static final int HALF = 54;

    private Quadrature() { }

    /** Mean of a function over the part of a convex polygon on the front side of a plane, times that part's share. */
    public static double mean(Vec3[] polygon, Vec3 inPlane, Vec3 planeNormal, ToDoubleFunction<Vec3> f) {
        List<Vec3> front = clip(polygon, inPlane, planeNormal);
        double sum = 0;
        for (int i = 2; i < front.size(); i++) {
            sum += triangle(front.get(0), front.get(i - 1), front.get(i), f);
        }
        return sum / area(List.of(polygon));
    }

    private static List<Vec3> clip(Vec3[] polygon, Vec3 inPlane, Vec3 normal) {
        List<Vec3> kept = new ArrayList<>();
        for (int i = 0; i < polygon.length; i++) {
            Vec3 a = polygon[i];
            Vec3 b = polygon[(i + 1) % polygon.length];
            double ha = normal.dot(a.minus(inPlane));
            double hb = normal.dot(b.minus(inPlane));
            if (ha >= 0) {
                kept.add(a);
            }
            if (ha * hb < 0) {
                kept.add(a.plus(b.minus(a).times(ha / (ha - hb))));
            }
        }
        return kept;
    }

    public static double area(List<Vec3> polygon) {
        Vec3 sum = Vec3.ZERO;
        for (int i = 2; i < polygon.size(); i++) {
            Vec3 a = polygon.get(0);
            sum = sum.plus(polygon.get(i - 1).minus(a).cross(polygon.get(i).minus(a)));
        }
        return sum.length() / 2;
    }

    /** M. G. Duffy's map: the square's side u = 0 becomes corner a. */
    private static double triangle(Vec3 a, Vec3 b, Vec3 c, ToDoubleFunction<Vec3> f) {
        double twice = b.minus(a).cross(c.minus(a)).length();
        double sum = 0;
        for (int i = -HALF; i <= HALF; i++) {
            double u = place(i);
            for (int j = -HALF; j <= HALF; j++) {
                double v = place(j);
                Vec3 p = a.plus(b.minus(a).times(u * (1 - v))).plus(c.minus(a).times(u * v));
                sum += weight(i) * weight(j) * u * f.applyAsDouble(p);
            }
        }
        return sum * twice;
    }

    private static double place(int i) {
        return 1 / (1 + Math.exp(-Math.PI * Math.sinh(i * STEP)));
    }

    private static double weight(int i) {
        double cosh = Math.cosh(Math.PI / 2 * Math.sinh(i * STEP));
        return STEP * Math.PI / 4 * Math.cosh(i * STEP) / (cosh * cosh);
    }
}
