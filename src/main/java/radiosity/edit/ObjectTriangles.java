package radiosity.edit;

import java.util.stream.IntStream;
import radiosity.scene.Hierarchy;
import radiosity.scene.Scene;
import radiosity.util.Aabb;

/** What belongs to an object of a scene. */
public final class ObjectTriangles {

    private ObjectTriangles() { }

    /** 1 per triangle: whether it belongs to a node or to what belongs to that. */
    static boolean[] triangles(Scene scene, int node) {
        Hierarchy hierarchy = scene.hierarchy();
        if (node < 0 || node >= hierarchy.nodes().size()) {
            throw new IllegalArgumentException("object: expected one of " + hierarchy.nodes().size() + ", got number "
                    + node);
        }
        boolean[] within = new boolean[hierarchy.nodes().size()];
        for (int n = 0; n < within.length; n++) {
            int parent = hierarchy.nodes().get(n).parent();
            within[n] = n == node || parent >= 0 && within[parent];
        }
        boolean[] triangles = new boolean[scene.triangles()];
        for (int t = 0; t < triangles.length; t++) {
            triangles[t] = within[hierarchy.of(t)];
        }
        return triangles;
    }

    /** The box around an object with triangles, scene units. */
    public static Aabb box(Scene scene, int node) {
        boolean[] triangles = triangles(scene, node);
        return Aabb.of(IntStream.range(0, 3 * triangles.length).filter(i -> triangles[i / 3])
                .mapToObj(i -> scene.corner(i / 3, i % 3)));
    }
}
