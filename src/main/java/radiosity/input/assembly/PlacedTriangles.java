package radiosity.input.assembly;

import java.util.Arrays;
import radiosity.util.PointNumbers;

/**
 * Collects the triangles of a scene while its meshes are placed, in the right-handed space of the scene. The corners of
 * the triangles of a mirrored mesh are reversed.
 */
final class PlacedTriangles {

    /** Twice a triangle's area, relative to the square of its longest edge, below which the area is only rounding. */
    private static final double NO_AREA = 1e-13;

    private double[] points;
    private final int[] corners;
    private final int[] surfaceOf;
    private final int[] nodeOf;
    private final float[] coordinates;
    private final float[] colours;
    private int pointCount;
    private int count;
    private int flat;

    /**
     * @param points    largest number of points
     * @param triangles largest number of triangles
     * @param textured  whether texture coordinates are kept
     * @param coloured  whether vertex colours are kept
     */
    PlacedTriangles(int points, int triangles, boolean textured, boolean coloured) {
        this.points = new double[3 * points];
        this.corners = new int[3 * triangles];
        this.surfaceOf = new int[triangles];
        this.nodeOf = new int[triangles];
        this.coordinates = new float[textured ? 6 * triangles : 0];
        Arrays.fill(coordinates, Float.NaN);
        this.colours = new float[coloured ? 9 * triangles : 0];
        Arrays.fill(colours, 1);
    }

    /**
     * Places a mesh.
     *
     * @param surfaces index in the scene of each of the mesh's surfaces
     * @param node     index of the hierarchy's node to which the mesh belongs
     */
    void add(TriangleMesh mesh, Placing placing, int[] surfaces, int node) {
        int firstPoint = pointCount;
        float[] p = mesh.points();
        for (int i = 0; i < p.length; i += 3) {
            int at = 3 * pointCount++;
            for (int k = 0; k < 3; k++) {
                points[at + k] = placing.point(k, p[i], p[i + 1], p[i + 2]);
            }
        }
        int second = placing.reverses() ? 2 : 1;
        for (int t = 0; t < mesh.triangles(); t++) {
            addTriangle(mesh, t, firstPoint, second, surfaces[mesh.surfaceOf()[t]], node);
        }
    }

    private void addTriangle(TriangleMesh mesh, int t, int firstPoint, int second, int surface, int node) {
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
        nodeOf[count] = node;
        if (mesh.textureCoordinates().length > 0) {
            copy(mesh.textureCoordinates(), t, second, 2, coordinates);
            forgetUnlessFinite(coordinates, 6 * count);
        }
        if (mesh.colours().length > 0) {
            copy(mesh.colours(), t, second, 3, colours);
        }
        count++;
    }

    /** A triangle of which a corner has no texture coordinates has no image: its six coordinates become NaN. */
    private static void forgetUnlessFinite(float[] coordinates, int first) {
        for (int i = first; i < first + 6; i++) {
            if (!Float.isFinite(coordinates[i])) {
                Arrays.fill(coordinates, first, first + 6, Float.NaN);
            }
        }
    }

    /** Copies the values of a triangle's corners, a number of values per corner, in the order of the placed corners. */
    private void copy(float[] from, int t, int second, int values, float[] to) {
        int[] order = {0, second, 3 - second};
        for (int k = 0; k < 3; k++) {
            System.arraycopy(from, values * (3 * t + order[k]), to, values * (3 * count + k), values);
        }
    }

    /**
     * Merges points at equal places, and numbers the points in the order of first use by the reversed triangles, which
     * is the order of LightWave's mirrored space. Sample points follow from these numbers, so that equal triangles get
     * equal light in all formats.
     */
    void shareEqualPoints() {
        int[] same = PointNumbers.of(points);
        int[] number = new int[pointCount];
        Arrays.fill(number, -1);
        double[] shared = new double[points.length];
        int used = 0;
        for (int i = 0; i < 3 * count; i++) {
            int at = i / 3 * 3 + (3 - i % 3) % 3;
            int p = same[corners[at]];
            if (number[p] < 0) {
                System.arraycopy(points, 3 * p, shared, 3 * used, 3);
                number[p] = used++;
            }
            corners[at] = number[p];
        }
        points = Arrays.copyOf(shared, 3 * used);
        pointCount = used;
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

    /** Number of triangles that were left out because they have no area in the scene. */
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

    int[] nodeOf() {
        return count == nodeOf.length ? nodeOf : Arrays.copyOf(nodeOf, count);
    }

    float[] textureCoordinates() {
        return 6 * count >= coordinates.length ? coordinates : Arrays.copyOf(coordinates, 6 * count);
    }

    float[] colours() {
        return 9 * count >= colours.length ? colours : Arrays.copyOf(colours, 9 * count);
    }
}
