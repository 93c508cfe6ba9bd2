package radiosity.mesh.face;

import java.util.stream.IntStream;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.BoxTree;

/** The triangles of a scene in boxes along three axes, to find those that reach into a box and through a plane. */
public final class TriangleBoxes {

    private static final Vec3 X = new Vec3(1, 0, 0);
    private static final Vec3 Y = new Vec3(0, 1, 0);
    private static final Vec3 Z = new Vec3(0, 0, 1);

    /** At right angles to each other, length 1. */
    private final Vec3[] axes;
    private final Vec3 origin;
    /** 1 per box: its triangle, ascending. */
    private final int[] triangles;
    private final BoxTree tree;
    /** Boxes that were looked at, for tests. */
    private long looks;

    private TriangleBoxes(Scene scene, int[] triangles, Vec3 origin, Vec3... axes) {
        this.axes = axes;
        this.origin = origin;
        this.triangles = triangles;
        double[] boxes = new double[6 * triangles.length];
        for (int i = 0; i < triangles.length; i++) {
            int t = triangles[i];
            for (int a = 0; a < 3; a++) {
                double p = scene.corner(t, 0).minus(origin).dot(axes[a]);
                double q = scene.corner(t, 1).minus(origin).dot(axes[a]);
                double r = scene.corner(t, 2).minus(origin).dot(axes[a]);
                boxes[6 * i + a] = Math.min(p, Math.min(q, r));
                boxes[6 * i + 3 + a] = Math.max(p, Math.max(q, r));
            }
        }
        tree = new BoxTree(boxes);
    }

    /** All, in boxes along the axes of the scene. */
    public static TriangleBoxes upright(Scene scene) {
        return new TriangleBoxes(scene, IntStream.range(0, scene.triangles()).toArray(), Vec3.ZERO, X, Y, Z);
    }

    /**
     * Some, in boxes of which one axis is a direction of length 1: triangles at right angles to it lie in flat ones.
     *
     * @param triangles ascending; not modified, kept
     */
    public static TriangleBoxes along(Scene scene, int[] triangles, Vec3 direction) {
        Vec3 least = Math.abs(direction.x()) < 0.5 ? X : Math.abs(direction.y()) < 0.5 ? Y : Z;
        Vec3 across = direction.cross(least).unit();
        return new TriangleBoxes(scene, triangles, scene.corner(0, 0), across, direction.cross(across), direction);
    }

    public long looks() {
        return looks;
    }

    /**
     * The triangles that may reach into a box, with a few that do not.
     *
     * @param box  low x, y, z, high x, y, z, scene units, 6 from {@code at}; not modified
     * @param near how far from the box is as good as in it, scene units
     * @return their numbers, ascending
     */
    public int[] reaching(double[] box, int at, double near) {
        return found(around(box, at, near));
    }

    /**
     * Of the triangles that may reach into a box those that may have a corner above a plane and another on it or below.
     *
     * @param on    a point of the plane
     * @param above direction of length 1
     */
    public int[] reaching(double[] box, int at, double near, Vec3 on, Vec3 above) {
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

    /** The box along this object's axes around a box along the scene's. */
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
