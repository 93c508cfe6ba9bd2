package radiosity.output.mesh;

import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.Aabb;
import radiosity.util.BoxTree;

/** Finds the element on which a point lies. Several threads may search at the same time. */
public final class ElementSearch {

    /** How far a point may lie from its element, relative to the diagonal of the box of all elements. */
    private static final double TOLERANCE = 1e-5;
    /** How far a point may lie from the nearest element beside a noisy surface, in the same unit. */
    private static final double NEAR = 1e-3;
    /** Least cosine between the normal of an element and the requested normal. */
    private static final double AGREES = 0.5;
    /** A cosine this much below 1 costs as much as a distance of the whole tolerance. */
    private static final double TURNED = 1e-4;

    private final Solution solution;
    private final BoxTree tree;
    private final double tolerance;

    public ElementSearch(Solution solution) {
        this.solution = solution;
        tolerance = TOLERANCE * Aabb.of(solution.positions()).diagonal();
        tree = new BoxTree(BoxTree.around(solution.elements(),
                (e, k, a) -> solution.positions()[3 * solution.corners()[3 * e + k] + a]));
    }

    /**
     * Index of the element at a point, or -1 if no element lies within the tolerance. Of several elements, the one with
     * the least sum of distance and deviation of the normal is found; of equal sums, the lowest index.
     *
     * @param point  scene units
     * @param normal unit direction out of the visible side of the element
     */
    public int find(Vec3 point, Vec3 normal) {
        double[] p = {point.x(), point.y(), point.z()};
        Best best = new Best();
        tree.near(p, p, tolerance, element -> {
            double cosine = Elements.normal(solution, element).dot(normal);
            double distance = cosine > AGREES ? new ClosestPoint(solution, element, point).distance() : tolerance * 2;
            if (distance <= tolerance) {
                best.offer(element, distance / tolerance + (1 - cosine) / TURNED);
            }
        });
        return best.element;
    }

    /**
     * Index of the nearest element within 1e-3 of the diagonal of the box of all elements, its normal within 60 degrees
     * of the one given, or -1; of equally near ones, the lowest index. A scanned floor is rough: a point measured on it
     * lies millimetres above or below its triangles.
     *
     * @param point  scene units
     * @param normal unit direction out of the visible side of the element
     */
    public int nearest(Vec3 point, Vec3 normal) {
        double[] p = {point.x(), point.y(), point.z()};
        double most = tolerance / TOLERANCE * NEAR;
        Best best = new Best();
        tree.near(p, p, most, element -> {
            double distance = Elements.normal(solution, element).dot(normal) > AGREES
                    ? new ClosestPoint(solution, element, point).distance() : Double.POSITIVE_INFINITY;
            if (distance <= most) {
                best.offer(element, distance);
            }
        });
        return best.element;
    }

    private static final class Best {

        private int element = -1;
        private double cost = Double.POSITIVE_INFINITY;

        void offer(int candidate, double itsCost) {
            if (itsCost < cost || itsCost == cost && candidate < element) {
                element = candidate;
                cost = itsCost;
            }
        }
    }
}
