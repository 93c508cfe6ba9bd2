package radiosity.output.image;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.IntStream;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.Aabb;
import radiosity.util.DisjointSets;
import radiosity.util.PointNumbers;

/** The parts of a scene whose triangles are connected by common corners, and the boxes that hold them. */
final class SceneObjects {

    /** Corners that differ by less, of the scene's diagonal, are one. */
    private static final double SAME_POINT = 1e-6;
    /** What extends over this share of the scene, in two directions and diagonally, encloses the scene or bears it. */
    private static final double SHELL = 0.5;
    /** By how much the box of an object is enlarged, of its diagonal, before an eye in it counts as outside. */
    private static final double MARGIN = 0.02;

    /** The lowest point of a triangle's object, 1 per triangle. */
    final int[] object;
    private final PrincipalAxes axes;
    /** Per lowest point: box along the axes. */
    private final Map<Integer, Aabb> boxes = new HashMap<>();
    private final Aabb whole;

    /** @param diagonal of the scene's box, scene units */
    SceneObjects(Scene scene, PrincipalAxes axes, double diagonal) {
        this.axes = axes;
        int[] corners = welded(scene, diagonal > 0 ? 1 / (SAME_POINT * diagonal) : 1);
        DisjointSets parts = new DisjointSets(scene.points().length / 3, corners);
        object = new int[scene.triangles()];
        for (int t = 0; t < object.length; t++) {
            int triangle = t;
            object[t] = parts.of(corners[3 * t]);
            boxes.merge(object[t], Aabb.of(IntStream.range(0, 3)
                    .mapToObj(k -> axes.coordinates(scene.corner(triangle, k)))), Aabb::with);
        }
        whole = boxes.values().stream().reduce(Aabb::with).orElse(new Aabb(Vec3.ZERO, Vec3.ZERO));
    }

    /** The scene's corners where each point is replaced by the first one in its place. */
    private static int[] welded(Scene scene, double cells) {
        int[] first = PointNumbers.of(Arrays.stream(scene.points()).map(x -> Math.rint(x * cells)).toArray());
        return Arrays.stream(scene.corners()).map(p -> first[p]).toArray();
    }

    /** Whether an object is what one stands in or on at a place, or extends over most of the scene. */
    boolean isShell(int itsObject, Vec3 eye) {
        Aabb box = boxes.get(itsObject);
        Vec3 p = axes.coordinates(eye);
        double margin = MARGIN * box.diagonal();
        boolean inside = true;
        int wide = 0;
        for (int a = 0; a < 3; a++) {
            inside &= p.coordinate(a) > box.low().coordinate(a) - margin
                    && p.coordinate(a) < box.high().coordinate(a) + margin;
            wide += box.extent().coordinate(a) >= SHELL * whole.extent().coordinate(a) ? 1 : 0;
        }
        return inside || wide >= 2 && box.diagonal() >= SHELL * whole.diagonal();
    }
}
