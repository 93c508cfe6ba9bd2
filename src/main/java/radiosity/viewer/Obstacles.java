package radiosity.viewer;

import java.util.List;
import java.util.Optional;
import radiosity.output.gltf.LitScene;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Vec3;
import radiosity.visibility.RadiosityBounds;

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
    private final RadiosityBounds bounds;

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
        bounds = new RadiosityBounds(unitCorners(scene.origin()));
    }

    /** Returns corners of all elements in coordinates of the scene scaled to size 1, 9 per element. */
    private float[] unitCorners(Vec3 origin) {
        float[] corners = new float[9 * first[meshes.size()]];
        int i = 0;
        for (Mesh mesh : meshes) {
            for (int e = 0; e < mesh.elements(); e++) {
                for (int k = 0; k < 3; k++) {
                    unit(mesh.position(e, k).plus(origin)).write(corners, i);
                    i += 3;
                }
            }
        }
        return corners;
    }

    private Vec3 unit(Vec3 p) {
        return p.minus(extent.centre()).times(1 / extent.size());
    }

    /**
     * Returns the nearest element whose visible side a ray meets.
     *
     * @param direction unit length
     * @param far       length of the ray, scene units
     */
    Optional<Hit> hit(Vec3 eye, Vec3 direction, double far) {
        float[] hit = new float[3];
        int found = bounds.nearestFront(unit(eye), direction, far / extent.size(), false, hit);
        return found < 0 ? Optional.empty() : Optional.of(hit(found, hit));
    }

    private Hit hit(int found, float[] hit) {
        int m = 0;
        while (first[m + 1] <= found) {
            m++;
        }
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
