package radiosity.output.image;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import radiosity.output.mesh.DisjointSets;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;

/** The parts of a scene whose triangles are connected by common corners, and the boxes that hold them. */
final class SceneObjects {

    /** Corners that differ by less, of the scene's diagonal, are one. */
    private static final double SAME_POINT = 1e-6;
    /** What extends over this share of the scene, in two directions and diagonally, encloses the scene or bears it. */
    private static final double SHELL = 0.5;
    /** By how much the box of an object is enlarged, of its diagonal, before an eye in it counts as outside. */
    private static final double MARGIN = 0.02;

    /** Spreads hash codes over a table. */
    private static final int SPREAD = 0x9E3779B9;

    /** The lowest point of a triangle's object, 1 per triangle. */
    final int[] object;
    private final PrincipalAxes axes;
    /** Per lowest point: lowest and highest coordinates along the axes. */
    private final Map<Integer, double[]> boxes = new HashMap<>();
    private final double[] whole = empty();

    /** @param diagonal of the scene's box, scene units */
    SceneObjects(Scene scene, PrincipalAxes axes, double diagonal) {
        this.axes = axes;
        int[] corners = welded(scene, diagonal > 0 ? 1 / (SAME_POINT * diagonal) : 1);
        DisjointSets parts = new DisjointSets(scene.points().length / 3, corners);
        object = new int[scene.triangles()];
        for (int t = 0; t < object.length; t++) {
            object[t] = parts.of(corners[3 * t]);
            double[] box = boxes.computeIfAbsent(object[t], none -> empty());
            for (int k = 0; k < 3; k++) {
                Vec3 p = axes.coordinates(scene.corner(t, k));
                include(box, p);
                include(whole, p);
            }
        }
    }

    /** The scene's corners where each point is replaced by the first one in its place. */
    private static int[] welded(Scene scene, double cells) {
        double[] points = scene.points();
        int[] first = new int[points.length / 3];
        int[] table = new int[Math.max(2, 4 * Integer.highestOneBit(Math.max(1, first.length)))];
        Arrays.fill(table, -1);
        for (int p = 0; p < first.length; p++) {
            Vec3 cell = cell(points, p, cells);
            int slot = Math.floorMod(cell.hashCode() * SPREAD >>> 7, table.length);
            while (table[slot] >= 0 && !cell(points, table[slot], cells).equals(cell)) {
                slot = (slot + 1) % table.length;
            }
            table[slot] = table[slot] < 0 ? p : table[slot];
            first[p] = table[slot];
        }
        int[] corners = new int[scene.corners().length];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = first[scene.corners()[i]];
        }
        return corners;
    }

    private static Vec3 cell(double[] points, int p, double cells) {
        return new Vec3(Math.rint(points[3 * p] * cells) + 0.0, Math.rint(points[3 * p + 1] * cells) + 0.0,
                Math.rint(points[3 * p + 2] * cells) + 0.0);
    }

    private static double[] empty() {
        double none = Double.POSITIVE_INFINITY;
        return new double[] {none, none, none, -none, -none, -none};
    }

    private static void include(double[] box, Vec3 p) {
        double[] c = {p.x(), p.y(), p.z()};
        for (int a = 0; a < 3; a++) {
            box[a] = Math.min(box[a], c[a]);
            box[a + 3] = Math.max(box[a + 3], c[a]);
        }
    }

    /** Whether an object is what one stands in or on at a place, or extends over most of the scene. */
    boolean isShell(int itsObject, Vec3 eye) {
        double[] box = boxes.get(itsObject);
        Vec3 p = axes.coordinates(eye);
        double[] c = {p.x(), p.y(), p.z()};
        double margin = MARGIN * diagonal(box);
        boolean inside = true;
        int wide = 0;
        for (int a = 0; a < 3; a++) {
            inside &= c[a] > box[a] - margin && c[a] < box[a + 3] + margin;
            wide += box[a + 3] - box[a] >= SHELL * (whole[a + 3] - whole[a]) ? 1 : 0;
        }
        return inside || wide >= 2 && diagonal(box) >= SHELL * diagonal(whole);
    }

    private static double diagonal(double[] box) {
        return new Vec3(box[3] - box[0], box[4] - box[1], box[5] - box[2]).length();
    }
}
