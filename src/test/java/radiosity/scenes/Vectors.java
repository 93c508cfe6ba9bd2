package radiosity.scenes;

/** Sums and products of points and directions: arrays of x, y, z, none of them modified. */
final class Vectors {

    static final double[] RIGHT = {1, 0, 0};
    static final double[] UP = {0, 1, 0};
    static final double[] AWAY = {0, 0, 1};

    private Vectors() {
    }

    static double[] point(double x, double y, double z) {
        return new double[] {x, y, z};
    }

    static double[] minus(double[] a, double[] b) {
        return plus(a, -1, b);
    }

    /** a + factor b. */
    static double[] plus(double[] a, double factor, double[] b) {
        return point(a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]);
    }

    static double[] times(double factor, double[] a) {
        return plus(new double[3], factor, a);
    }

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    static double[] cross(double[] a, double[] b) {
        return point(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    }

    static double[] unit(double[] a) {
        return times(1 / Math.sqrt(dot(a, a)), a);
    }
}
