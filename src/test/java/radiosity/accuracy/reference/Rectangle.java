package radiosity.accuracy.reference;

/**
 * A rectangle in space, visible from the side of u x v. All arrays hold x, y, z in m and are not modified.
 *
 * @param origin one corner
 * @param u      one edge from that corner
 * @param v      the other edge, perpendicular to u
 */
record Rectangle(Material material, double[] origin, double[] u, double[] v) {

    double area() {
        return Math.sqrt(dot(u, u) * dot(v, v));
    }

    /** Unit normal on the visible side. */
    double[] normal() {
        double[] n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        return new double[] {n[0] / area(), n[1] / area(), n[2] / area()};
    }

    /**
     * The point at two parts of the edges.
     *
     * @param s part of u, in [0, 1]
     * @param t part of v, in [0, 1]
     */
    double[] at(double s, double t) {
        double[] p = new double[3];
        for (int i = 0; i < 3; i++) {
            p[i] = origin[i] + s * u[i] + t * v[i];
        }
        return p;
    }

    /** Distance from a point to the nearest point of the rectangle, m. */
    double distance(double[] p) {
        double[] d = {p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]};
        double[] nearest = at(clamp(dot(d, u) / dot(u, u)), clamp(dot(d, v) / dot(v, v)));
        double[] away = {p[0] - nearest[0], p[1] - nearest[1], p[2] - nearest[2]};
        return Math.sqrt(dot(away, away));
    }

    private static double clamp(double part) {
        return Math.max(0, Math.min(1, part));
    }

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
