package radiosity.mesh.cut;

import java.util.stream.IntStream;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.BoxTree;

/** Boxes around a scene's triangles along three axes: finds triangles that reach into a box and through a plane. */
final class TriangleBoxes {

    private static final Vec3 X = new Vec3(1, 0, 0);
    private static final Vec3 Y = new Vec3(0, 1, 0);
    private static final Vec3 Z = new Vec3(0, 0, 1);

    /** At right angles to each other, length 1. */
    private final Vec3[] axes;
    private final Vec3 origin;
    /** 1 per box: its triangle, ascending. */
    private final int[] triangles;
    private final BoxTree tree;
    /** Number of boxes that were tested; read by tests. */
    private long looks;

    private TriangleBoxes(Scene scene, int[] triangles, Vec3 origin, Vec3... axes) {
        this.axes = axes;
        this.origin = origin;
        this.triangles = triangles;
        tree = new BoxTree(BoxTree.around(triangles.length,
                (i, k, a) -> scene.corner(triangles[i], k).minus(origin).dot(axes[a])));
    }

    /** Boxes of all triangles, along the axes of the scene. */
    static TriangleBoxes upright(Scene scene) {
        return new TriangleBoxes(scene, IntStream.range(0, scene.triangles()).toArray(), Vec3.ZERO, X, Y, Z);
    }

    /**
     * Boxes of some triangles, with one axis along a unit vector: triangles at right angles to it have flat boxes.
     *
     * @param triangles ascending; not modified, kept
     */
    static TriangleBoxes along(Scene scene, int[] triangles, Vec3 direction) {
        Vec3 least = Math.abs(direction.x()) < 0.5 ? X : Math.abs(direction.y()) < 0.5 ? Y : Z;
        Vec3 across = direction.cross(least).unit();
        return new TriangleBoxes(scene, triangles, scene.corner(0, 0), across, direction.cross(across), direction);
    }

    long looks() {
        return looks;
    }

    /**
     * The triangles that may reach into a box; a few of them do not.
     *
     * @param box  low x, y, z, high x, y, z, scene units, 6 from {@code at}; not modified
     * @param near distance from the box that still counts as inside, scene units
     * @return numbers of the triangles, ascending
     */
    int[] reaching(double[] box, int at, double near) {
        return found(around(box, at, near));
    }

    /**
     * The triangles that may reach into a box and may have a corner above a plane and another on or below the plane.
     *
     * @param on    a point of the plane, scene units
     * @param above unit normal of the plane
     */
    int[] reaching(double[] box, int at, double near, Vec3 on, Vec3 above) {
        BoxTree.Region around = around(box, at, near);
        double[] slope = {above.dot(axes[0]), above.dot(axes[1]), above.dot(axes[2])};
        double level = on.minus(origin).dot(above);
        return found((boxes, i) -> around.meets(boxes, i) && passes(boxes, i, slope, level, near));
    }

    private int[] found(BoxTree.Region region) {
        IntStream.Builder found = IntStream.builder();
        tree.any(region, i -> {
            found.add(triangles[i]);
            return false;
        });
        return found.build().sorted().toArray();
    }

    /** The region around a box along the scene's axes, as a box along this object's axes. */
    private BoxTree.Region around(double[] box, int at, double near) {
        Vec3 low = new Vec3(box[at], box[at + 1], box[at + 2]);
        Vec3 half = new Vec3(box[at + 3], box[at + 4], box[at + 5]).minus(low).times(0.5);
        Vec3 middle = low.plus(half).minus(origin);
        double[] from = new double[3];
        double[] to = new double[3];
        for (int a = 0; a < 3; a++) {
            double reach = Math.abs(axes[a].x()) * half.x() + Math.abs(axes[a].y()) * half.y()
                    + Math.abs(axes[a].z()) * half.z() + near;
            from[a] = middle.dot(axes[a]) - reach;
            to[a] = middle.dot(axes[a]) + reach;
        }
        return (boxes, i) -> {
            looks++;
            return boxes[i] <= to[0] && boxes[i + 3] >= from[0] && boxes[i + 1] <= to[1] && boxes[i + 4] >= from[1]
                    && boxes[i + 2] <= to[2] && boxes[i + 5] >= from[2];
        };
    }

    private static boolean passes(double[] boxes, int i, double[] slope, double level, double near) {
        double middle = -level;
        double reach = 0;
        for (int a = 0; a < 3; a++) {
            middle += slope[a] * (boxes[i + 3 + a] + boxes[i + a]) / 2;
            reach += Math.abs(slope[a]) * (boxes[i + 3 + a] - boxes[i + a]) / 2;
        }
        return middle + reach > near / 4 && middle - reach < near;
    }
}
