package radiosity.viewer;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import radiosity.output.gltf.LitScene;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Vec3;
import radiosity.visibility.ScaledBounds;

/** A BVH over all elements of a scene, which stops steps before walls and finds the element under the mouse. */
final class Obstacles {

    /** Least distance of the eye from a wall, relative to the scene's size. */
    private static final double MARGIN = 0.004;
    /** Most walls along which one step slides. */
    private static final int SLIDES = 3;

    private final List<Mesh> meshes;
    private final Extent extent;
    /** 1 per mesh: number of its first element; then the number of all elements. */
    private final int[] first;
    /** 1 per element of all meshes: number of its mesh. */
    private final int[] meshOf;
    private final ScaledBounds scaled;

    /**
     * Intersection of a ray with an element.
     *
     * @param mesh     number of the mesh, a side of a surface
     * @param element  number of the element in the mesh
     * @param v        barycentric weight of corner 1
     * @param w        barycentric weight of corner 2
     * @param distance distance from the eye, scene units
     * @param normal   unit normal out of the visible side
     */
    record Hit(int mesh, int element, double v, double w, double distance, Vec3 normal) { }

    Obstacles(LitScene scene) {
        meshes = scene.meshes();
        extent = Extent.of(scene);
        first = new int[meshes.size() + 1];
        for (int m = 0; m < meshes.size(); m++) {
            first[m + 1] = first[m] + meshes.get(m).elements();
        }
        meshOf = new int[first[meshes.size()]];
        for (int m = 0; m < meshes.size(); m++) {
            Arrays.fill(meshOf, first[m], first[m + 1], m);
        }
        scaled = new ScaledBounds(extent.centre(), extent.size(), meshOf.length, i -> meshes.get(meshOf[i / 3])
                .position(i / 3 - first[meshOf[i / 3]], i % 3).plus(scene.origin()));
    }

    /**
     * Returns the nearest element whose visible side a ray meets.
     *
     * @param direction unit length
     * @param far       length of the ray, scene units
     */
    Optional<Hit> hit(Vec3 eye, Vec3 direction, double far) {
        float[] hit = new float[3];
        int found = scaled.bounds.nearestFront(scaled.unit(eye), direction, far / extent.size(), false, hit);
        return found < 0 ? Optional.empty() : Optional.of(hit(found, hit));
    }

    private Hit hit(int found, float[] hit) {
        int m = meshOf[found];
        Mesh mesh = meshes.get(m);
        int e = found - first[m];
        return new Hit(m, e, hit[1], hit[2], hit[0] * extent.size(), mesh.cross(e).unit());
    }

    /** Returns the part of a step that walls allow; a step that meets a wall slides along the wall. */
    Vec3 allowed(Vec3 eye, Vec3 step) {
        Vec3 left = step;
        for (int slide = 0; slide < SLIDES; slide++) {
            double length = left.length();
            if (length == 0) {
                return Vec3.ZERO;
            }
            double margin = MARGIN * extent.size();
            Optional<Hit> wall = hit(eye, left.times(1 / length), length + 2 * margin);
            if (wall.isEmpty()) {
                return left;
            }
            Vec3 n = wall.get().normal();
            double towards = -left.dot(n);
            double room = wall.get().distance() * towards / length - margin;
            if (towards <= Math.max(0, room)) {
                return left;
            }
            left = left.plus(n.times(towards - Math.max(0, room)));
        }
        return Vec3.ZERO;
    }
}
