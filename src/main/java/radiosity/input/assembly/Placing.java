package radiosity.input.assembly;

import radiosity.scene.Affine;

/**
 * Placement of a mesh in the scene.
 *
 * @param world  map from the mesh's space to the scene's, which may be left-handed
 * @param back   whether the map leads to a left-handed space, LightWave's, whose z is the scene's -z
 * @param origin offset added in the scene, 3 coordinates in double precision, scene units
 */
public record Placing(Affine world, boolean back, double[] origin) {

    private static final double[] NOWHERE_ELSE = new double[3];

    /** A placement by a map to the scene's right-handed space. */
    public static Placing of(Affine world) {
        return new Placing(world, false, NOWHERE_ELSE);
    }

    /** A placement by a map to LightWave's left-handed space: (x, y, z) becomes (x, y, -z). */
    public static Placing leftHanded(Affine world) {
        return new Placing(world, true, NOWHERE_ELSE);
    }

    /** Coordinate k (0, 1 or 2), in the scene, of the point x, y, z of the mesh. */
    double point(int k, double x, double y, double z) {
        double at = world.point(k, x, y, z);
        return origin[k] + (k == 2 && back ? 0 - at : at);
    }

    /** Whether the corners of triangles run the other way round in the scene than in the mesh. */
    boolean reverses() {
        return back ? world.determinant() >= 0 : world.determinant() < 0;
    }
}
