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

/** The objects of a scene: parts whose triangles are connected by common corners, each with the box that holds it. */
final class SceneObjects {

    /** Corners are one point if their coordinates round to the same multiple of this, of the scene's diagonal. */
    private static final double SAME_POINT = 1e-6;
    /** An object that extends over this share of the scene, in two directions and diagonally, encloses or bears it. */
    private static final double SHELL = 0.5;
    /** Margin within which an eye outside an object's box counts as inside, of the diagonal of the box. */
    private static final double MARGIN = 0.02;

    /** 1 per triangle: the object, named by its lowest point. */
    final int[] object;
    private final PrincipalAxes axes;
    /** The box along the axes of each object. */
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

    /**
     * The scene's corners, each point replaced by the first point that rounds to the same cell; cells per scene unit.
     */
    private static int[] welded(Scene scene, double cells) {
        int[] first = PointNumbers.of(Arrays.stream(scene.points()).map(x -> Math.rint(x * cells)).toArray());
        return Arrays.stream(scene.corners()).map(p -> first[p]).toArray();
    }

    /** Whether the eye is inside the box of an object, or the object extends over most of the scene. */
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
