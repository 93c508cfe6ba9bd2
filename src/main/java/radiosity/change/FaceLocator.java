package radiosity.change;

import radiosity.mesh.face.Faces;
import radiosity.scene.Vec3;
import radiosity.util.BoxTree;

/** Finds on which of some faces a place lies. */
final class FaceLocator {

    /** Of the scene's size. */
    private static final double NEAR = 1e-5;
    /** What a weight of a corner may lack at an edge. */
    private static final double OUTSIDE = 1e-3;
    private static final double SAME_PLANE = 0.999;

    private final Faces faces;
    private final int[] some;
    private final long[] group;
    private final BoxTree boxes;

    /**
     * A place on a face.
     *
     * @param weights of the face's three corners, each at least 0, of sum 1
     */
    record Place(int face, double[] weights) { }

    /** @param group 1 per face of all: only faces of the group that is asked for are found */
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
     * The face of a group in whose plane, on the side of a normal, a point lies.
     *
     * @param p scene units
     * @return null where there is none
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

    /**
     * Goes from a triangle to that of its four children in which a place lies.
     *
     * @param weights modified: of the child's corners
     * @return the child
     */
    static int descend(double[] weights) {
        int child = 3;
        for (int k = 0; k < 3; k++) {
            child = weights[k] > 0.5 ? k : child;
        }
        for (int k = 0; k < 3; k++) {
            weights[k] = child == 3 ? 1 - 2 * weights[k] : k == child ? 2 * weights[k] - 1 : 2 * weights[k];
        }
        return child;
    }
}
