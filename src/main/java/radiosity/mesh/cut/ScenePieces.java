package radiosity.mesh.cut;

import java.util.Arrays;
import radiosity.scene.Hierarchy;
import radiosity.scene.Scene;

/** Collects triangles that are, or are pieces of, the triangles of a scene, and makes a scene of them. */
public final class ScenePieces {

    /**
     * A scene some of whose triangles are cut.
     *
     * @param origin 1 per triangle of the scene: the triangle of the given scene that it is, or is a piece of
     */
    public record Cut(Scene scene, int[] origin) { }

    private final Scene scene;
    /** 3 per triangle: its points. */
    private int[] corners;
    /** 1 per triangle: the triangle of the given scene that it is, or is a piece of. */
    private int[] origin;
    private int triangles;

    ScenePieces(Scene scene) {
        this.scene = scene;
        corners = new int[scene.corners().length];
        origin = new int[scene.triangles()];
    }

    /** Number of triangles so far. */
    int count() {
        return triangles;
    }

    /** @param from the triangle of the given scene that the new triangle with corners a, b, c is, or is a piece of */
    void add(int a, int b, int c, int from) {
        if (triangles == origin.length) {
            origin = Arrays.copyOf(origin, 2 * triangles);
            corners = Arrays.copyOf(corners, 6 * triangles);
        }
        corners[3 * triangles] = a;
        corners[3 * triangles + 1] = b;
        corners[3 * triangles + 2] = c;
        origin[triangles++] = from;
    }

    /** Adds a triangle of the given scene whole. */
    void add(int triangle) {
        int[] of = scene.corners();
        add(of[3 * triangle], of[3 * triangle + 1], of[3 * triangle + 2], triangle);
    }

    /**
     * The scene of all triangles added.
     *
     * @param points  x, y, z of all points, scene units; kept
     * @param earlier 1 per triangle of the scene that was given: the triangle of an earlier scene that it is a piece of
     */
    Cut cut(double[] points, int[] earlier) {
        int[] first = new int[triangles];
        Arrays.setAll(first, t -> earlier[origin[t]]);
        return new Cut(scene(points), first);
    }

    private Scene scene(double[] points) {
        float[] texture = new float[scene.textureCoordinates().length == 0 ? 0 : 6 * triangles];
        float[] colours = new float[scene.vertexColours().length == 0 ? 0 : 9 * triangles];
        int[] nodeOf = new int[scene.hierarchy().nodeOf().length == 0 ? 0 : triangles];
        int[] surfaceOf = new int[triangles];
        for (int t = 0; t < triangles; t++) {
            surfaceOf[t] = scene.surfaceOf()[origin[t]];
            if (nodeOf.length > 0) {
                nodeOf[t] = scene.hierarchy().of(origin[t]);
            }
            if (texture.length > 0) {
                System.arraycopy(scene.textureCoordinates(), 6 * origin[t], texture, 6 * t, 6);
            }
            if (colours.length > 0) {
                System.arraycopy(scene.vertexColours(), 9 * origin[t], colours, 9 * t, 9);
            }
        }
        return new Scene(scene.name(), points, Arrays.copyOf(corners, 3 * triangles), surfaceOf, scene.surfaces(),
                scene.lights(), scene.camera(), texture, colours, new Hierarchy(scene.hierarchy().nodes(), nodeOf),
                scene.units());
    }

    /** Whether a triangle has neither texture coordinates nor colours, so that its pieces need none of their own. */
    static boolean isPlain(Scene scene, int triangle) {
        return (scene.textureCoordinates().length == 0 || Float.isNaN(scene.textureCoordinates()[6 * triangle]))
                && !scene.isColoured(triangle);
    }
}
