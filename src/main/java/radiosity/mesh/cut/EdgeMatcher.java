package radiosity.mesh.cut;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import radiosity.mesh.face.CutPoints;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.SceneBox;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.BoxTree;
import radiosity.util.PointNumbers;

/**
 * Divides large triangles at T-vertices: corners of other triangles of the same surface, in the same plane, that lie
 * inside an edge, as where a wall is modelled as rectangles around a window. Otherwise light would be interpolated
 * between different points on both sides of the edge, which would show as a seam.
 *
 * <p>A mesh for radiosity has no T-vertices: D. Baum, S. Mann, K. Smith, J. Winget, Making radiosity usable, 1991.
 */
public final class EdgeMatcher {

    /** Largest length of the difference between unit normals of two triangles in one plane. */
    private static final double SAME_DIRECTION = 1e-5;
    /** Least distance between points on an edge, in heights of the triangle above the edge, so that pieces are wide. */
    private static final double LEAST_WIDTH = 0.03125;
    /** Most points around a triangle that is divided: more take long to cut, and would replace the mesh by pieces. */
    private static final int MOST = 256;

    private final Scene scene;
    /** 1 per point: the lowest point with the same coordinates. */
    private final int[] number;
    private final TriangleBoxes boxes;
    /** Largest distance of a point from an edge on which it lies, scene units. */
    private final double near;

    private EdgeMatcher(Scene scene) {
        this.scene = scene;
        number = PointNumbers.of(scene.points());
        boxes = TriangleBoxes.upright(scene);
        near = Faces.NEAR * SceneBox.of(scene).size();
    }

    /**
     * Divides the large triangles of a scene that have T-vertices on their edges; without any, the scene stays the
     * same. Triangles with texture coordinates or colours stay whole, and those with very many T-vertices.
     *
     * @param cut a scene that may consist of pieces already
     * @return the pieces, with the triangles of the same given scene as origins
     */
    public static ScenePieces.Cut match(ScenePieces.Cut cut) {
        Scene scene = cut.scene();
        EdgeMatcher matcher = new EdgeMatcher(scene);
        ScenePieces pieces = new ScenePieces(scene);
        CutPoints points = new CutPoints(scene, matcher.near);
        double least = DiscontinuityMesher.LEAST_AREA * scene.area();
        for (int t = 0; t < scene.triangles(); t++) {
            List<Integer> loop = scene.area(t) > least && ScenePieces.isPlain(scene, t) ? matcher.loop(t) : List.of();
            if (loop.size() <= 3 || loop.size() > MOST) {
                pieces.add(t);
                continue;
            }
            int[] corners = loop.stream().mapToInt(p -> p).toArray();
            for (int[] piece : new ConvexTriangulator(points, scene.cross(t).unit()).triangles(corners)) {
                pieces.add(piece[0], piece[1], piece[2], t);
            }
        }
        return pieces.count() == scene.triangles() ? cut : pieces.cut(scene.points(), cut.origin());
    }

    /** The corners of a triangle and the T-vertices on its edges, counter-clockwise. */
    private List<Integer> loop(int t) {
        List<Integer> around = corners(t);
        List<Integer> loop = new ArrayList<>();
        for (int k = 0; k < 3; k++) {
            loop.add(scene.corners()[3 * t + k]);
            loop.addAll(inside(t, k, around));
        }
        return loop;
    }

    /** The corners, each once, of all triangles that lie in the plane of a triangle, face its way, have its surface. */
    private List<Integer> corners(int t) {
        Vec3 normal = scene.cross(t).unit();
        Vec3 origin = scene.corner(t, 0);
        List<Integer> found = new ArrayList<>();
        for (int u : boxes.reaching(BoxTree.around(1, (one, k, a) -> scene.corner(t, k).coordinate(a)), 0, near)) {
            boolean isInPlane = u != t && scene.surfaceOf()[u] == scene.surfaceOf()[t]
                    && scene.cross(u).unit().minus(normal).length() < SAME_DIRECTION;
            for (int k = 0; k < 3 && isInPlane; k++) {
                isInPlane = Math.abs(scene.corner(u, k).minus(origin).dot(normal)) <= near;
            }
            for (int k = 0; k < 3 && isInPlane; k++) {
                found.add(number[scene.corners()[3 * u + k]]);
            }
        }
        return found.stream().distinct().toList();
    }

    /** Those of some points that lie inside the edge from corner k to corner k + 1, in its direction. */
    private List<Integer> inside(int t, int k, List<Integer> some) {
        Vec3 from = scene.corner(t, k);
        Vec3 along = scene.corner(t, (k + 1) % 3).minus(from);
        double length = along.length();
        Vec3 direction = along.times(1 / length);
        double least = Math.max(2 * near, LEAST_WIDTH * scene.cross(t).length() / length);
        List<Integer> on = some.stream()
                .filter(p -> scene.point(p).minus(from).cross(direction).length() <= near)
                .sorted(Comparator.comparingDouble(p -> scene.point(p).minus(from).dot(direction))).toList();
        List<Integer> inside = new ArrayList<>();
        double last = 0;
        for (int p : on) {
            double at = scene.point(p).minus(from).dot(direction);
            if (at - last >= least && length - at >= least) {
                inside.add(p);
                last = at;
            }
        }
        return inside;
    }
}
