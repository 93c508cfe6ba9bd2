package radiosity.edit;

import java.util.Optional;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;

/**
 * The first point of an edited scene on a ray.
 *
 * @param triangle number of the triangle
 * @param point    intersection of ray and triangle, scene units
 */
public record Picked(int triangle, Vec3 point) {

    /**
     * Intersects a ray with all triangles, whose number is small compared with the number of elements. Rays pass
     * through the back of one-sided triangles.
     *
     * @param direction any length but 0
     */
    public static Optional<Picked> of(Scene scene, Vec3 eye, Vec3 direction) {
        double nearest = Double.POSITIVE_INFINITY;
        int triangle = -1;
        for (int t = 0; t < scene.triangles(); t++) {
            double distance = distance(scene, t, eye, direction);
            if (distance < nearest) {
                nearest = distance;
                triangle = t;
            }
        }
        return triangle < 0 ? Optional.empty()
                : Optional.of(new Picked(triangle, eye.plus(direction.times(nearest))));
    }

    /** Distance in lengths of the direction, infinite where the ray misses (T. Möller, B. Trumbore, 1997). */
    private static double distance(Scene scene, int t, Vec3 eye, Vec3 direction) {
        Vec3 a = scene.corner(t, 0);
        Vec3 ab = scene.corner(t, 1).minus(a);
        Vec3 ac = scene.corner(t, 2).minus(a);
        Vec3 p = direction.cross(ac);
        double determinant = ab.dot(p);
        if (!(determinant > 0 || determinant < 0 && scene.surface(t).twoSided())) {
            return Double.POSITIVE_INFINITY;
        }
        Vec3 from = eye.minus(a);
        Vec3 q = from.cross(ab);
        double v = from.dot(p) / determinant;
        double w = direction.dot(q) / determinant;
        double distance = ac.dot(q) / determinant;
        return v >= 0 && w >= 0 && v + w <= 1 && distance > 0 ? distance : Double.POSITIVE_INFINITY;
    }
}
