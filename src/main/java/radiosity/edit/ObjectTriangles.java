package radiosity.edit;

import java.util.stream.IntStream;
import radiosity.scene.Affine;
import radiosity.scene.Hierarchy;
import radiosity.scene.Scene;
import radiosity.util.Aabb;

/** Finds the triangles and the position of an object of a scene. */
public final class ObjectTriangles {

    private ObjectTriangles() { }

    /**
     * 1 per node of the hierarchy: whether the node is this object or below this object.
     *
     * @throws IllegalArgumentException where the scene has no object of this number
     */
    public static boolean[] nodes(Scene scene, int node) {
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
        return within;
    }

    /** 1 per triangle: whether the triangle belongs to this object or to an object below. */
    static boolean[] triangles(Scene scene, int node) {
        boolean[] within = nodes(scene, node);
        boolean[] triangles = new boolean[scene.triangles()];
        for (int t = 0; t < triangles.length; t++) {
            triangles[t] = within[scene.hierarchy().of(t)];
        }
        return triangles;
    }

    /** The box around an object and the objects below, scene units; where they have no triangles, the origin. */
    public static Aabb box(Scene scene, int node) {
        return box(scene, triangles(scene, node), true);
    }

    /** The box around all triangles for which the set has this value, scene units; the origin where there are none. */
    static Aabb box(Scene scene, boolean[] set, boolean within) {
        return Aabb.of(IntStream.range(0, 3 * set.length).filter(i -> set[i / 3] == within)
                .mapToObj(i -> scene.corner(i / 3, i % 3)));
    }

    /** Maps a node's own space to scene space; the identity for -1. */
    static Affine place(Hierarchy hierarchy, int node) {
        Affine place = Affine.IDENTITY;
        for (int n = node; n >= 0; n = hierarchy.nodes().get(n).parent()) {
            place = hierarchy.nodes().get(n).placement().times(place);
        }
        return place;
    }

    /** Maps an object's position in one scene to that in another; the identity where the map is not finite. */
    public static Affine between(Scene from, Scene to, int node) {
        Affine map = place(to.hierarchy(), node).times(place(from.hierarchy(), node).inverse());
        return map.isFinite() ? map : Affine.IDENTITY;
    }
}
