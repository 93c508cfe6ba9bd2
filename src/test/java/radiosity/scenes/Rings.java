package radiosity.scenes;

/**
 * Closed lines of points, x, y, z each, between which {@link Solids#loft} stretches a skin.
 *
 * <p>All run from +x towards +z, so that a loft that goes up has its front outside. Sines are strict, because the
 * files must come out the same on every machine.
 */
final class Rings {

    private Rings() {
    }

    /** A level circle of n points. */
    static double[][] circle(double x, double y, double z, double radius, int n) {
        return around(Vectors.point(x, y, z), Vectors.RIGHT, Vectors.AWAY, radius, n);
    }

    /** A circle of n points across the line from a to b, about the point c. */
    static double[][] across(double[] a, double[] b, double[] c, double radius, int n) {
        double[] along = Vectors.unit(Vectors.minus(b, a));
        double[] other = Math.abs(along[1]) < 0.9 ? Vectors.UP : Vectors.AWAY;
        double[] v = Vectors.unit(Vectors.cross(other, along));
        return around(c, Vectors.cross(along, v), v, radius, n);
    }

    private static double[][] around(double[] centre, double[] u, double[] v, double radius, int n) {
        double[][] ring = new double[n][];
        for (int k = 0; k < n; k++) {
            double angle = 2 * Math.PI * k / n;
            double[] p = Vectors.plus(centre, radius * StrictMath.cos(angle), u);
            ring[k] = Vectors.plus(p, radius * StrictMath.sin(angle), v);
        }
        return ring;
    }

    /** A level rectangle. */
    static double[][] rectangle(double x0, double z0, double x1, double z1, double y) {
        return new double[][] {{x1, y, z1}, {x0, y, z1}, {x0, y, z0}, {x1, y, z0}};
    }

    /** A level rectangle whose corners are quarter circles of two points each. */
    static double[][] rounded(double x0, double z0, double x1, double z1, double y, double radius) {
        double[][] corners = rectangle(x0 + radius, z0 + radius, x1 - radius, z1 - radius, y);
        double[][] ring = new double[8][];
        for (int k = 0; k < ring.length; k++) {
            double angle = Math.PI / 2 * (k / 2 + k % 2);
            ring[k] = Vectors.plus(corners[k / 2], radius,
                    Vectors.point(StrictMath.cos(angle), 0, StrictMath.sin(angle)));
        }
        return ring;
    }
}
