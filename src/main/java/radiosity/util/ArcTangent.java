package radiosity.util;

/**
 * The angle of a point (x, y), y >= 0, by + - * / only: the same bits on every machine, at a third of the cost of
 * {@code StrictMath.atan2}. The error is below 1e-15.
 */
public final class ArcTangent {

    /** Coefficients of fdlibm's s_atan.c (Sun Microsystems, 1993): atan t = t - t (t^2 (A0 + A1 t^2 + ...)). */
    private static final double A0 = 3.33333333333329318027e-01;
    private static final double A1 = -1.99999999998764832476e-01;
    private static final double A2 = 1.42857142725034663711e-01;
    private static final double A3 = -1.11111104054623557880e-01;
    private static final double A4 = 9.09088713343650656196e-02;
    private static final double A5 = -7.69187620504482999495e-02;
    private static final double A6 = 6.66107313738753120669e-02;
    private static final double A7 = -5.83357013379057348645e-02;
    private static final double A8 = 4.97687799461593236017e-02;
    private static final double A9 = -3.65315727442169155270e-02;
    private static final double A10 = 1.62858201153657823623e-02;
    /** tan(pi/8): largest argument for which the polynomial is used. */
    private static final double REACH = 0.41421356237309503;

    private ArcTangent() { }

    /** The angle in [0, pi] divided by y, which is at least 0; where y is 0, 1/x for x above 0 and NaN for x = 0. */
    public static double overSine(double y, double x) {
        if (y <= x * REACH) {
            double t = y / x;
            return (1 - t * t * series(t * t)) / x;
        }
        return angle(y, x) / y;
    }

    private static double angle(double y, double x) {
        double ax = Math.abs(x);
        if (ax <= y * REACH) {
            return Math.PI / 2 - small(x / y);
        }
        if (y <= ax * REACH) {
            return Math.PI - small(y / ax);
        }
        double t = small((y - ax) / (y + ax));
        return x > 0 ? Math.PI / 4 + t : 3 * Math.PI / 4 - t;
    }

    private static double small(double t) {
        return t - t * (t * t * series(t * t));
    }

    private static double series(double z) {
        double w = z * z;
        double even = A0 + w * (A2 + w * (A4 + w * (A6 + w * (A8 + w * A10))));
        double odd = A1 + w * (A3 + w * (A5 + w * (A7 + w * A9)));
        return even + z * odd;
    }
}
