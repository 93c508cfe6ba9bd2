package radiosity.visibility;

/**
 * Ray-triangle tests: a fast test by three planes in floats, which decides all but close calls, and an exact test by
 * the triangle's corners in double for close calls.
 *
 * <p>Distance from the triangle's plane, and the weights of corners 1 and 2, are linear in space: D. Baldwin, M. Weber,
 * Fast ray-triangle intersections by coordinate transformation, 2016. Close calls: T. Moeller, B. Trumbore, Fast,
 * minimum storage ray/triangle intersection, 1997. A filter in floats before an exact test: J. Shewchuk, Adaptive
 * precision floating-point arithmetic and fast robust geometric predicates, 1997.
 */
final class PackedTriangle {

    /**
     * Numbers per triangle: distance from the plane, weight of corner 1, weight of corner 2, each as the coefficients
     * of a x + b y + c z + d; largest change of a weight over a distance of 1; as bits, the triangle's number; two
     * unused.
     */
    static final int SIZE = 16;
    private static final int STEEPNESS = 12;
    private static final int NUMBER = 13;
    /** Weight of a corner, below 0, down to which a point beyond an edge still counts as on the triangle. */
    static final float EDGE = 1e-5f;
    /** Distance from a plane, in units of the scene's size, up to which a point lies on the plane. */
    private static final double OFF_PLANE = 2e-7;

    private PackedTriangle() {
    }

    /** Twice the area of a triangle, |a x b| of its edges a and b; its 9 coordinates begin at k. */
    static float doubleArea(float[] corners, int k) {
        double[] n = cross(edge(corners, k, 3), edge(corners, k, 6));
        return (float) length(n);
    }

    /** Writes a triangle. The planes of a triangle without area are zeros, which make every ray a close call. */
    static void put(float[] corners, int k, float[] data, int at) {
        double[] a = edge(corners, k, 3);
        double[] b = edge(corners, k, 6);
        double[] n = cross(a, b);
        double square = dot(n, n);
        data[at + NUMBER] = Float.intBitsToFloat(k / 9);
        if (square > 0) {
            putPlane(n, length(n), corners, k, data, at);
            putPlane(cross(b, n), square, corners, k, data, at + 4);
            putPlane(cross(n, a), square, corners, k, data, at + 8);
            data[at + STEEPNESS] = (float) ((length(a) + length(b)) / Math.sqrt(square));
        }
    }

    /** Writes the plane with gradient g / scale that is 0 at the triangle's corner 0. */
    private static void putPlane(double[] g, double scale, float[] corners, int k, float[] data, int at) {
        double d = 0;
        for (int a = 0; a < 3; a++) {
            data[at + a] = (float) (g[a] / scale);
            d -= g[a] / scale * corners[k + a];
        }
        data[at + 3] = (float) d;
    }

    /** Number of the triangle written at a place. */
    static int number(float[] data, int at) {
        return Float.floatToRawIntBits(data[at + NUMBER]);
    }

    /**
     * Whether a segment meets the inside of a triangle, and both ends are clear of the triangle's plane.
     *
     * @param mx    middle of the segment: mx, my, mz
     * @param hx    vector from the middle to one end, no longer than the scene: hx, hy, hz
     * @param slack upper bound of the distance by which rounding shifts a point of the segment
     * @param clear least distance of an end from the plane for a sure hit
     * @return 1 a sure hit, -1 a sure miss, 0 a close call
     */
    static int meets(float[] p, int k, float mx, float my, float mz, float hx, float hy, float hz, float slack,
                     float clear) {
        float above = p[k] * mx + p[k + 1] * my + p[k + 2] * mz + p[k + 3];
        float rise = p[k] * hx + p[k + 1] * hy + p[k + 2] * hz;
        float reach = Math.abs(rise) - Math.abs(above);
        if (reach < -slack) {
            return -1;
        }
        float slope = 1 / rise;
        float at = -above * slope;
        float x = mx + at * hx;
        float y = my + at * hy;
        float z = mz + at * hz;
        float error = p[k + STEEPNESS] * slack * (1 + Math.abs(slope));
        float u = p[k + 4] * x + p[k + 5] * y + p[k + 6] * z + p[k + 7];
        if (u < -error - EDGE) {
            return -1;
        }
        float v = p[k + 8] * x + p[k + 9] * y + p[k + 10] * z + p[k + 11];
        float w = 1 - u - v;
        if (v < -error - EDGE || w < -error - EDGE) {
            return -1;
        }
        return u > error && v > error && w > error && reach > clear ? 1 : 0;
    }

    /**
     * Whether a line meets a triangle, computed in double.
     *
     * @param origin    a point of the line; not modified
     * @param direction direction of the line; not modified
     * @param hit       modified where the line does: distance in units of the direction, weights of corners 1 and 2
     */
    static boolean cuts(float[] corners, int k, double[] origin, double[] direction, double[] hit) {
        double[] a = edge(corners, k, 3);
        double[] b = edge(corners, k, 6);
        double[] p = cross(direction, b);
        double det = dot(a, p);
        double[] s = {origin[0] - corners[k], origin[1] - corners[k + 1], origin[2] - corners[k + 2]};
        double[] q = cross(s, a);
        double u = dot(s, p) / det;
        double v = dot(direction, q) / det;
        if (!(Math.min(Math.min(u, v), 1 - u - v) >= -EDGE)) {
            return false;
        }
        hit[0] = dot(b, q) / det;
        hit[1] = u;
        hit[2] = v;
        return true;
    }

    /** Whether a ray that meets a triangle comes from the side on which the corners run counter-clockwise. */
    static boolean faces(float[] corners, int k, double[] direction) {
        return dot(cross(edge(corners, k, 3), edge(corners, k, 6)), direction) < 0;
    }

    /**
     * Whether a triangle's plane lies between the ends of a segment, and both ends are farther from the plane than
     * float coordinates are inexact. Without the second condition a wall would hide itself from points near it, as the
     * ray's end lies on the wall but for rounding; and a long triangle would hide what is seen from it at a small
     * angle.
     */
    static boolean separates(float[] corners, int k, double[] origin, double[] direction) {
        double[] n = cross(edge(corners, k, 3), edge(corners, k, 6));
        double[] s = {origin[0] - corners[k], origin[1] - corners[k + 1], origin[2] - corners[k + 2]};
        double from = dot(n, s);
        double to = from + dot(n, direction);
        double least = OFF_PLANE * length(n);
        return from > least && to < -least || from < -least && to > least;
    }

    private static double[] edge(float[] c, int k, int to) {
        return new double[] {(double) c[k + to] - c[k], (double) c[k + to + 1] - c[k + 1],
            (double) c[k + to + 2] - c[k + 2]};
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private static double length(double[] a) {
        return Math.sqrt(dot(a, a));
    }

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
