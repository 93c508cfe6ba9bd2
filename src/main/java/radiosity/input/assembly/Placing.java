package radiosity.input.assembly;

import radiosity.scene.Affine;

/**
 * Where a mesh stands in the scene.
 *
 * @param world  from the mesh's space to the scene's, left-handed or not
 * @param back   whether the scene's z is the opposite of where the map leads, as from LightWave's left-handed space
 * @param origin what is added in the scene, 3 numbers, in double precision
 */
public record Placing(Affine world, boolean back, double[] origin) {

    private static final double[] NOWHERE_ELSE = new double[3];

    /** In a right-handed space. */
    public static Placing of(Affine world) {
        return new Placing(world, false, NOWHERE_ELSE);
    }

    /** In LightWave's space: (x, y, z) becomes (x, y, -z). */
    public static Placing leftHanded(Affine world) {
        return new Placing(world, true, NOWHERE_ELSE);
    }

    /** Coordinate k (0, 1 or 2) of a point in the scene. */
    double point(int k, double x, double y, double z) {
        double at = world.point(k, x, y, z);
        return origin[k] + (k == 2 && back ? 0 - at : at);
    }

    /** Whether corners run the other way round in the scene than in the mesh. */
    boolean reverses() {
        return back ? world.determinant() >= 0 : world.determinant() < 0;
    }
}
