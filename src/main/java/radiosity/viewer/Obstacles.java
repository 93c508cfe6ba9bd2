package radiosity.viewer;

import java.util.List;
import java.util.Optional;
import radiosity.output.gltf.LitScene;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Vec3;
import radiosity.visibility.RadiosityBounds;

/** All elements of a scene, to stop a step before a wall and to find what is under the mouse. */
final class Obstacles {

    /** Nobody comes closer to a wall than this, of the scene's size. */
    private static final double MARGIN = 0.004;
    /** How often a ray may pass through the back of a surface. */
    private static final int PASSES = 32;
    /** Behind a surface a ray goes on from here, of the scene's size. */
    private static final double STEP = 1e-5;
    /** How often a step slides along another wall. */
    private static final int SLIDES = 3;

    private final List<Mesh> meshes;
    private final Extent extent;
    /** The first element of each mesh, and the number of all. */
    private final int[] first;
    private final RadiosityBounds bounds;

    /**
     * What a ray meets.
     *
     * @param mesh     number of the side of a surface
     * @param element  of the mesh
     * @param v        weight of corner 1
     * @param w        weight of corner 2
     * @param distance scene units
     * @param normal   unit, out of the visible side
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

    /** The corners in a scene of size 1 around the origin, as {@link RadiosityBounds} wants them. */
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
     * The nearest surface whose visible side a ray meets.
     *
     * @param direction unit
     * @param far       scene units
     */
    Optional<Hit> hit(Vec3 eye, Vec3 direction, double far) {
        Vec3 o = unit(eye);
        double reach = far / extent.size();
        double from = 0;
        float[] hit = new float[3];
        for (int pass = 0; pass < PASSES && from < reach; pass++) {
            int found = bounds.nearest(o.plus(direction.times(from)), direction, reach - from, hit);
            if (found < 0) {
                return Optional.empty();
            }
            from += hit[0];
            Hit seen = hit(found, hit, from * extent.size());
            if (seen.normal().dot(direction) < 0) {
                return Optional.of(seen);
            }
            from += STEP;
        }
        return Optional.empty();
    }

    private Hit hit(int found, float[] hit, double distance) {
        int m = 0;
        while (first[m + 1] <= found) {
            m++;
        }
        Mesh mesh = meshes.get(m);
        int e = found - first[m];
        return new Hit(m, e, hit[1], hit[2], distance, mesh.cross(e).unit());
    }

    /** How much of a step can be taken: before a wall it goes on along it. */
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
