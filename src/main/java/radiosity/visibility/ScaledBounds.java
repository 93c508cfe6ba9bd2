package radiosity.visibility;

import java.util.function.IntFunction;
import radiosity.scene.Vec3;
import radiosity.util.Aabb;

/** The bounds of triangles that are given in scene units and brought to size 1 around the origin. */
public final class ScaledBounds {

    /** 1 over the size of the scene, scene units. */
    public final double scale;
    public final RadiosityBounds bounds;
    private final Vec3 centre;

    /**
     * @param box       its diagonal becomes 1
     * @param triangles number of triangles
     * @param corners   corner k of triangle t by the number 3 t + k, scene units
     */
    public ScaledBounds(Aabb box, int triangles, IntFunction<Vec3> corners) {
        this(box.centre(), box.diagonal() > 0 ? box.diagonal() : 1, triangles, corners);
    }

    /** @param size becomes 1, scene units, above 0 */
    public ScaledBounds(Vec3 centre, double size, int triangles, IntFunction<Vec3> corners) {
        this.centre = centre;
        scale = 1 / size;
        float[] unit = new float[9 * triangles];
        for (int i = 0; i < 3 * triangles; i++) {
            unit(corners.apply(i)).write(unit, 3 * i);
        }
        bounds = new RadiosityBounds(unit);
    }

    /** A point of the scene in the coordinates of the bounds. */
    public Vec3 unit(Vec3 p) {
        return p.minus(centre).times(scale);
    }
}
