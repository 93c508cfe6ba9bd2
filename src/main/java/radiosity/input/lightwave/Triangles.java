package radiosity.input.lightwave;

import java.util.Arrays;
import radiosity.input.lightwave.lws.Matrix;

/**
 * The triangles of a scene while its objects are placed: right-handed, in the scene's space.
 *
 * <p>(x, y, z) becomes (x, y, -z), and as that mirrors, the corners are taken the other way round; an object that is
 * mirrored itself is turned once more.
 */
final class Triangles {

    /** A triangle with less than this share of the square of its longest edge is rounding. */
    private static final double NO_AREA = 1e-13;

    private final double[] points;
    private final int[] corners;
    private final int[] surfaceOf;
    private final float[] coordinates;
    private int pointCount;
    private int count;
    private int flat;

    /** @param textured whether texture coordinates are kept */
    Triangles(int points, int triangles, boolean textured) {
        this.points = new double[3 * points];
        this.corners = new int[3 * triangles];
        this.surfaceOf = new int[triangles];
        this.coordinates = new float[textured ? 6 * triangles : 0];
        Arrays.fill(coordinates, Float.NaN);
    }

    /**
     * Places a mesh.
     *
     * @param surfaces the scene's number of each of the mesh's surfaces
     */
    void add(ObjectMesh mesh, Matrix world, int[] surfaces) {
        int firstPoint = pointCount;
        float[] p = mesh.points();
        for (int i = 0; i < p.length; i += 3) {
            int at = 3 * pointCount++;
            points[at] = world.point(0, p[i], p[i + 1], p[i + 2]);
            points[at + 1] = world.point(1, p[i], p[i + 1], p[i + 2]);
            points[at + 2] = 0 - world.point(2, p[i], p[i + 1], p[i + 2]);
        }
        boolean reversed = world.determinant() >= 0;
        for (int t = 0; t < mesh.triangles(); t++) {
            int second = reversed ? 2 : 1;
            addTriangle(mesh, t, firstPoint, second, surfaces[mesh.surfaceOf()[t]]);
        }
    }

    private void addTriangle(ObjectMesh mesh, int t, int firstPoint, int second, int surface) {
        int a = firstPoint + mesh.corners()[3 * t];
        int b = firstPoint + mesh.corners()[3 * t + second];
        int c = firstPoint + mesh.corners()[3 * t + 3 - second];
        if (!hasArea(a, b, c)) {
            flat++;
            return;
        }
        corners[3 * count] = a;
        corners[3 * count + 1] = b;
        corners[3 * count + 2] = c;
        surfaceOf[count] = surface;
        if (mesh.textureCoordinates().length > 0) {
            copyCoordinates(mesh.textureCoordinates(), 6 * t, 0, 0);
            copyCoordinates(mesh.textureCoordinates(), 6 * t, second, 1);
            copyCoordinates(mesh.textureCoordinates(), 6 * t, 3 - second, 2);
        }
        count++;
    }

    private void copyCoordinates(float[] from, int at, int corner, int to) {
        coordinates[6 * count + 2 * to] = from[at + 2 * corner];
        coordinates[6 * count + 2 * to + 1] = from[at + 2 * corner + 1];
    }

    private boolean hasArea(int a, int b, int c) {
        double x = normal(a, b, c, 0);
        double y = normal(a, b, c, 1);
        double z = normal(a, b, c, 2);
        double longest = Math.max(square(a, b), Math.max(square(b, c), square(c, a)));
        return Math.sqrt(x * x + y * y + z * z) > NO_AREA * longest;
    }

    private double square(int a, int b) {
        double x = points[3 * a] - points[3 * b];
        double y = points[3 * a + 1] - points[3 * b + 1];
        double z = points[3 * a + 2] - points[3 * b + 2];
        return x * x + y * y + z * z;
    }

    private double normal(int a, int b, int c, int k) {
        int u = (k + 1) % 3;
        int v = (k + 2) % 3;
        return (points[3 * b + u] - points[3 * a + u]) * (points[3 * c + v] - points[3 * a + v])
                - (points[3 * b + v] - points[3 * a + v]) * (points[3 * c + u] - points[3 * a + u]);
    }

    /** Triangles that were left out because they have no area in the scene. */
    int flat() {
        return flat;
    }

    double[] points() {
        return points;
    }

    int[] corners() {
        return 3 * count == corners.length ? corners : Arrays.copyOf(corners, 3 * count);
    }

    int[] surfaceOf() {
        return count == surfaceOf.length ? surfaceOf : Arrays.copyOf(surfaceOf, count);
    }

    float[] textureCoordinates() {
        return coordinates.length == 0 || 6 * count == coordinates.length ? coordinates
                : Arrays.copyOf(coordinates, 6 * count);
    }
}
