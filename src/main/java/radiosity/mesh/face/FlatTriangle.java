package radiosity.mesh.face;

/** A triangle beside others in its plane, or nearly so, in the scene brought to size 1. */
public final class FlatTriangle {

    /** Bound on the rounding of coordinates, in units of the scene's size. */
    private static final double ROUNDING = 1e-7;

    private final float[] corners;
    /** x, y, z per edge: from the edge's line to the third corner, at right angles to the edge; NaN without area. */
    private final double[] inwards = new double[9];
    /** 1 per edge: length of {@code inwards}. */
    private final double[] height = new double[3];

    /** @param corners x, y, z of three corners; kept, so the caller must not modify the array */
    public FlatTriangle(float[] corners) {
        this.corners = corners;
        for (int k = 0; k < 3; k++) {
            int next = (k + 1) % 3;
            int third = (k + 2) % 3;
            double along = dot(k, next, third) / dot(k, next, next);
            double squared = 0;
            for (int i = 0; i < 3; i++) {
                double edge = (double) corners[3 * next + i] - corners[3 * k + i];
                double into = (double) corners[3 * third + i] - corners[3 * k + i] - along * edge;
                inwards[3 * k + i] = into;
                squared += into * into;
            }
            height[k] = Math.sqrt(squared);
        }
    }

    /** Dot product of the edges from one corner to two others. */
    private double dot(int from, int to, int other) {
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            double start = corners[3 * from + i];
            sum += (corners[3 * to + i] - start) * (corners[3 * other + i] - start);
        }
        return sum;
    }

    /**
     * Whether another triangle lies beyond an edge, so that the two share no more than points of that edge. A triangle
     * without area has any other beyond an edge.
     *
     * @param other x, y, z of three corners, 9 from {@code at}; not modified
     */
    public boolean hasBeyondAnEdge(float[] other, int at) {
        for (int k = 0; k < 9; k += 3) {
            double most = Math.max(depth(k, other, at), Math.max(depth(k, other, at + 3), depth(k, other, at + 6)));
            if (!(most > ROUNDING * height[k / 3])) {
                return true;
            }
        }
        return false;
    }

    /** Depth of a point inside an edge, times the triangle's height above the edge. */
    private double depth(int edge, float[] point, int at) {
        return inwards[edge] * ((double) point[at] - corners[edge])
                + inwards[edge + 1] * ((double) point[at + 1] - corners[edge + 1])
                + inwards[edge + 2] * ((double) point[at + 2] - corners[edge + 2]);
    }
}
