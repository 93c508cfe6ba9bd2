package radiosity.accuracy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
import radiosity.world.Solution;

/**
 * A solution at given points: linear between the vertices of the element on which a point lies. Searches all elements of
 * the faces at the point; for tests, where there are few.
 */
public final class Evaluate {

    /** Faces that miss a point by no more than this are taken to hold it, of the scene's size. */
    private static final double NEAR = 1e-6;

    private final Solution solution;
    private final List<List<Integer>> elementsOf = new ArrayList<>();
    private final double size;

    public Evaluate(Solution solution) {
        this.solution = solution;
        for (int t = 0; t < solution.scene().triangles(); t++) {
            elementsOf.add(new ArrayList<>());
        }
        for (int e = 0; e < solution.elements(); e++) {
            elementsOf.get(solution.faceOf()[e] >> 1).add(e);
        }
        size = Math.sqrt(solution.scene().area());
    }

    /** An element and the weights of its corners at a point. */
    private record Hit(int element, double[] weights, double miss) { }

    /**
     * Emitted and reflected radiosity.
     *
     * @param places x, y, z, nx, ny, nz per point; not modified
     * @return r, g, b per point, W/m²; NaN where there is no element
     */
    public double[] radiosity(double[] places) {
        double[] found = new double[places.length / 2];
        for (int i = 0; i < places.length / 6; i++) {
            Rgb b = radiosity(new Vec3(places[6 * i], places[6 * i + 1], places[6 * i + 2]),
                    new Vec3(places[6 * i + 3], places[6 * i + 4], places[6 * i + 5]));
            for (int c = 0; c < 3; c++) {
                found[3 * i + c] = b.channel(c);
            }
        }
        return found;
    }

    /** Radiosity at a point of a surface with that normal, W/m². */
    public Rgb radiosity(Vec3 point, Vec3 normal) {
        Hit hit = find(point, normal);
        return hit == null ? Rgb.grey(Double.NaN) : mix(hit, k -> solution.radiosityAt(hit.element, k));
    }

    /** Irradiance at a point of a surface with that normal, W/m². */
    public Rgb irradiance(Vec3 point, Vec3 normal) {
        Hit hit = find(point, normal);
        return hit == null ? Rgb.grey(Double.NaN)
                : mix(hit, k -> solution.irradianceAt(solution.corners()[3 * hit.element + k]));
    }

    private static Rgb mix(Hit hit, IntFunction<Rgb> corner) {
        double[] sum = new double[3];
        for (int k = 0; k < 3; k++) {
            for (int c = 0; c < 3; c++) {
                sum[c] += hit.weights[k] * corner.apply(k).channel(c);
            }
        }
        return new Rgb(sum[0], sum[1], sum[2]);
    }

    private Hit find(Vec3 point, Vec3 normal) {
        double[] miss = new double[elementsOf.size()];
        for (int t = 0; t < miss.length; t++) {
            miss[t] = elementsOf.get(t).isEmpty() ? Double.MAX_VALUE : hit(-1, point, normal,
                    solution.scene().corner(t, 0), solution.scene().corner(t, 1), solution.scene().corner(t, 2)).miss;
        }
        double least = Arrays.stream(miss).min().orElse(Double.MAX_VALUE);
        Hit best = null;
        for (int t = 0; t < miss.length; t++) {
            for (int e : miss[t] <= least + NEAR * size && miss[t] < 0.01 * size ? elementsOf.get(t) : List.<Integer>of()) {
                Hit hit = hit(e, point, normal, corner(e, 0), corner(e, 1), corner(e, 2));
                best = best == null || hit.miss < best.miss ? hit : best;
            }
        }
        return best;
    }

    private Vec3 corner(int element, int k) {
        int p = 3 * solution.corners()[3 * element + k];
        return new Vec3(solution.positions()[p], solution.positions()[p + 1], solution.positions()[p + 2]);
    }

    /** How far a point is from a triangle, roughly, and where in it; not at all where the triangle faces another way. */
    private static Hit hit(int element, Vec3 point, Vec3 normal, Vec3 a, Vec3 b, Vec3 c) {
        Vec3 twice = b.minus(a).cross(c.minus(a));
        double area = twice.length();
        double wb = point.minus(a).cross(c.minus(a)).dot(twice) / (area * area);
        double wc = b.minus(a).cross(point.minus(a)).dot(twice) / (area * area);
        double outside = Math.max(0, -Math.min(1 - wb - wc, Math.min(wb, wc)));
        double away = Math.abs(point.minus(a).dot(twice)) / area;
        boolean turned = Math.abs(normal.unit().dot(twice) / area) < 0.99;
        double miss = turned || area == 0 ? Double.MAX_VALUE : away + outside * Math.sqrt(area);
        return new Hit(element, inside(1 - wb - wc, wb, wc), miss);
    }

    private static double[] inside(double... weights) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            weights[k] = Math.max(0, weights[k]);
            sum += weights[k];
        }
        for (int k = 0; k < 3; k++) {
            weights[k] /= sum;
        }
        return weights;
    }
}
