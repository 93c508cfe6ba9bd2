package radiosity.mesh.face;

/** Triangles in one plane, or nearly so: x, y, z of three corners each, in the scene brought to size 1. */
public final class FlatTriangles {

    /** Bound on the rounding of coordinates, in units of the scene's size. */
    private static final double ROUNDING = 1e-7;

    private FlatTriangles() {
    }

    /**
     * Whether two triangles share no more than points of their edges: whether one has an edge with the other beyond it.
     * A triangle without area is beside any other.
     *
     * @param a 9 numbers, not modified; so is {@code b}
     */
    public static boolean areApart(float[] a, float[] b) {
        return hasBeyondAnEdge(a, b) || hasBeyondAnEdge(b, a);
    }

    private static boolean hasBeyondAnEdge(float[] triangle, float[] other) {
        for (int k = 0; k < 3; k++) {
            int next = (k + 1) % 3;
            int third = (k + 2) % 3;
            double along = dot(triangle, k, next, triangle, third) / dot(triangle, k, next, triangle, next);
            double[] inwards = new double[3];
            double squared = 0;
            for (int i = 0; i < 3; i++) {
                double edge = (double) triangle[3 * next + i] - triangle[3 * k + i];
                inwards[i] = (double) triangle[3 * third + i] - triangle[3 * k + i] - along * edge;
                squared += inwards[i] * inwards[i];
            }
            double most = Double.NEGATIVE_INFINITY;
            for (int j = 0; j < 9; j += 3) {
                double depth = 0;
                for (int i = 0; i < 3; i++) {
                    depth += inwards[i] * ((double) other[j + i] - triangle[3 * k + i]);
                }
                most = Math.max(most, depth);
            }
            if (!(most > ROUNDING * Math.sqrt(squared))) {
                return true;
            }
        }
        return false;
    }

    /** Dot product of the edges of a triangle from one corner to a second, and to a corner of another triangle. */
    private static double dot(float[] triangle, int from, int to, float[] other, int corner) {
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            sum += ((double) triangle[3 * to + i] - triangle[3 * from + i])
                    * ((double) other[3 * corner + i] - triangle[3 * from + i]);
        }
        return sum;
    }
}
