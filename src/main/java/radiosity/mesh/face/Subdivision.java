package radiosity.mesh.face;

/** Division of a triangle in four: corners of the children, and values at these corners. */
public final class Subdivision {

    private Subdivision() { }

    /**
     * Replaces a triangle by one of its four children.
     *
     * @param at x, y, z of three corners; modified
     */
    public static void descend(float[] at, int child) {
        child(at, 0, child, at, 0);
    }

    /**
     * Finds the corners of one of the four children of a triangle.
     *
     * @param from x, y, z of three corners, 9 from {@code i}; not modified unless it is {@code to}
     * @param to   modified: x, y, z of the child's corners, 9 from {@code j}
     */
    public static void child(float[] from, int i, int child, float[] to, int j) {
        for (int a = 0; a < 3; a++) {
            float p = from[i + a];
            float q = from[i + 3 + a];
            float r = from[i + 6 + a];
            float pq = 0.5f * (p + q);
            float qr = 0.5f * (q + r);
            float rp = 0.5f * (r + p);
            to[j + a] = child == 0 ? p : child == 1 ? pq : child == 2 ? rp : qr;
            to[j + 3 + a] = child == 0 ? pq : child == 1 ? q : child == 2 ? qr : rp;
            to[j + 6 + a] = child == 0 ? rp : child == 1 ? qr : child == 2 ? r : pq;
        }
    }

    /**
     * Finds which of the four children of a triangle contains a point.
     *
     * @param weights 3: barycentric weights of the triangle's corners at the point; modified: those of the child's
     * @return the child's number
     */
    public static int enter(double[] weights) {
        int child = weights[0] >= 0.5 ? 0 : weights[1] >= 0.5 ? 1 : weights[2] >= 0.5 ? 2 : 3;
        for (int k = 0; k < 3; k++) {
            weights[k] = child == 3 ? 1 - 2 * weights[k] : 2 * weights[k] - (k == child ? 1 : 0);
        }
        return child;
    }

    /**
     * Interpolates values at the corners of a triangle at the corners of one of its children.
     *
     * @param values n values per corner; not modified
     * @return n values per corner of the child
     */
    public static double[] values(double[] values, int n, int child) {
        double[] of = new double[3 * n];
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < 3; k++) {
                int p = child == 3 ? (k + 1) % 3 : k;
                int q = child == 3 ? (k + 2) % 3 : child;
                of[n * k + i] = 0.5 * (values[n * p + i] + values[n * q + i]);
            }
        }
        return of;
    }
}
