package radiosity.change;

import radiosity.mesh.face.Faces;
import radiosity.scene.Vec3;
import radiosity.util.BoxTree;

/** Finds the face, among some of a scene's faces, on which a point lies. */
final class FaceLocator {

    /** Distance from a face within which a point counts as on the face, relative to the scene size. */
    private static final double NEAR = 1e-5;
    /** How far below 0 the barycentric weight of a corner may be, for a point at an edge. */
    private static final double OUTSIDE = 1e-3;
    private static final double SAME_PLANE = 0.999;

    private final Faces faces;
    private final int[] some;
    private final long[] group;
    private final BoxTree boxes;

    /**
     * A point on a face.
     *
     * @param weights barycentric weights of the face's three corners, each at least 0, of sum 1
     */
    record Place(int face, double[] weights) { }

    /**
     * @param some  faces that may be found
     * @param group 1 per face of the scene: group of the face, see {@link #find}
     */
    FaceLocator(Faces faces, int[] some, long[] group) {
        this.faces = faces;
        this.some = some;
        this.group = group;
        double[] box = new double[6 * some.length];
        for (int i = 0; i < some.length; i++) {
            for (int a = 0; a < 3; a++) {
                double p = faces.sceneCorner(some[i], 0, a);
                double q = faces.sceneCorner(some[i], 1, a);
                double r = faces.sceneCorner(some[i], 2, a);
                box[6 * i + a] = Math.min(p, Math.min(q, r));
                box[6 * i + 3 + a] = Math.max(p, Math.max(q, r));
            }
        }
        boxes = new BoxTree(box);
    }

    /**
     * Finds the face of a group in whose plane a point lies, where the face looks the same way as a normal.
     *
     * @param p      scene units
     * @param normal unit length
     * @return null where there is no face; where there are several, the one whose least barycentric weight is largest
     */
    Place find(Vec3 p, Vec3 normal, long wanted) {
        double[] at = {p.x(), p.y(), p.z()};
        Place[] best = new Place[1];
        double[] least = {-OUTSIDE};
        boxes.near(at, at, NEAR * faces.size(), i -> {
            int f = some[i];
            if (group[f] != wanted || faces.exactNormal(f).dot(normal) < SAME_PLANE) {
                return;
            }
            double[] weights = weights(f, p);
            double low = Math.min(weights[0], Math.min(weights[1], weights[2]));
            boolean isBetter = low > least[0] || low == least[0] && best[0] != null && f < best[0].face;
            if (isBetter && Math.abs(p.minus(faces.sceneCorner(f, 0)).dot(normal)) < 2 * NEAR * faces.size()) {
                least[0] = low;
                best[0] = new Place(f, weights);
            }
        });
        return best[0] == null ? null : new Place(best[0].face, clamped(best[0].weights));
    }

    private double[] weights(int f, Vec3 p) {
        Vec3 a = faces.sceneCorner(f, 0);
        Vec3 ab = faces.sceneCorner(f, 1).minus(a);
        Vec3 ac = faces.sceneCorner(f, 2).minus(a);
        Vec3 n = ab.cross(ac);
        double b = n.dot(p.minus(a).cross(ac)) / n.dot(n);
        double c = n.dot(ab.cross(p.minus(a))) / n.dot(n);
        return new double[] {1 - b - c, b, c};
    }

    private static double[] clamped(double[] weights) {
        double sum = 0;
        double[] clamped = new double[3];
        for (int k = 0; k < 3; k++) {
            clamped[k] = Math.max(0, weights[k]);
            sum += clamped[k];
        }
        for (int k = 0; k < 3; k++) {
            clamped[k] /= sum;
        }
        return clamped;
    }
}
