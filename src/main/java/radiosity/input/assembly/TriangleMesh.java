package radiosity.input.assembly;

/**
 * Triangles of a mesh in the mesh's own space, shared by all instances of the mesh. The arrays must not be modified.
 *
 * @param points             x, y, z of each point that a triangle uses, all finite
 * @param corners            3 point indices per triangle, counter-clockwise seen from the visible side where the space
 *                           is right-handed, clockwise where it is left-handed
 * @param surfaceOf          index among the mesh's surfaces, 1 per triangle
 * @param textureCoordinates u, v of each corner, v upwards, 6 per triangle; NaN where a triangle has none; empty if no
 *                           triangle has any
 * @param colours            red, green, blue in [0, 1] of each corner, 9 per triangle; empty if there are none
 */
public record TriangleMesh(float[] points, int[] corners, int[] surfaceOf, float[] textureCoordinates,
                           float[] colours) {

    public int triangles() {
        return surfaceOf.length;
    }

    public int pointCount() {
        return points.length / 3;
    }
}
