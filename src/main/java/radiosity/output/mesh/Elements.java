package radiosity.output.mesh;

import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;

/** The geometry of a solution's elements. */
public final class Elements {

    private Elements() {
    }

    public static Vec3 corner(Solution solution, int element, int k) {
        int p = 3 * solution.corners()[3 * element + k];
        double[] x = solution.positions();
        return new Vec3(x[p], x[p + 1], x[p + 2]);
    }

    /**
     * The point of an element with given barycentric weights, scene units; corner 0 has the weight 1 - v - w.
     *
     * @param v weight of corner 1
     * @param w weight of corner 2
     */
    public static Vec3 point(Solution solution, int element, double v, double w) {
        return corner(solution, element, 0).times(1 - v - w).plus(corner(solution, element, 1).times(v))
                .plus(corner(solution, element, 2).times(w));
    }

    /** Irradiance H at a point of an element, with weights as in {@link #point}, W/m². */
    public static Rgb irradiance(Solution solution, int element, double v, double w) {
        int[] corners = solution.corners();
        return solution.irradianceAt(corners[3 * element]).times(1 - v - w)
                .plus(solution.irradianceAt(corners[3 * element + 1]).times(v))
                .plus(solution.irradianceAt(corners[3 * element + 2]).times(w));
    }

    /** Vector normal to an element out of its visible side, twice as long as its area is large, square scene units. */
    public static Vec3 cross(Solution solution, int element) {
        Vec3 a = corner(solution, element, 0);
        return corner(solution, element, 1).minus(a).cross(corner(solution, element, 2).minus(a));
    }

    /**
     * Corner k (0, 1 or 2) of the original triangle of a face, counter-clockwise seen from the face's visible side,
     * scene units.
     *
     * @param face 2 * original triangle, + 1 for its back
     */
    public static Vec3 corner(Scene scene, int face, int k) {
        return scene.corner(face >> 1, (face & 1) == 0 ? k : (3 - k) % 3);
    }

    /**
     * Unit normal of an element out of its visible side. The original triangle's normal is used, as it is more exact
     * than that of the element.
     */
    public static Vec3 normal(Solution solution, int element) {
        return normal(solution.scene(), solution.faceOf()[element]);
    }

    /**
     * Unit normal of a face out of its visible side; of a triangle without area, +Y on its front and -Y on its back.
     *
     * @param face 2 * original triangle, + 1 for its back
     */
    public static Vec3 normal(Scene scene, int face) {
        Vec3 cross = scene.cross(face >> 1);
        Vec3 front = cross.length() > 0 ? cross.unit() : new Vec3(0, 1, 0);
        return (face & 1) == 0 ? front : Vec3.ZERO.minus(front);
    }
}
