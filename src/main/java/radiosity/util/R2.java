package radiosity.util;

/**
 * The R2 sequence: a low-discrepancy sequence of points in the unit square (M. Roberts, The unreasonable effectiveness
 * of quasirandom sequences, 2018). By number as doubles; or one after another as 32-bit fractions of 1, which is
 * quicker, with pseudo-random numbers (lots) for choosing among the points.
 */
public final class R2 {

    private static final double STEP_U = 0.7548776662466927;
    private static final double STEP_V = 0.5698402909980532;
    /** Differences between the coordinates of consecutive points, modulo 2^32. */
    public static final int U = 0xC13FA9A9;
    public static final int V = 0x91E10DA6;

    private R2() { }

    /** First coordinate, in [0, 1), of the point with this number, which is 0 or more. */
    public static double u(double number) {
        return number * STEP_U % 1;
    }

    /** Second coordinate, in [0, 1), of the point with this number, which is 0 or more. */
    public static double v(double number) {
        return number * STEP_V % 1;
    }

    /** The upper 24 bits as a number in [0, 1). */
    public static float unit(int bits) {
        return (bits >>> 8) * 0x1p-24f;
    }

    /** Mask for an exclusive or with u and v, which mirrors points with u + v of 1 or more into the triangle. */
    public static int fold(int u, int v) {
        return -((u >>> 8) + (v >>> 8) >>> 24);
    }

    /** The first of a sequence of lots. */
    public static int lot(long rotation) {
        return (int) (rotation * 0x9E3779B97F4A7C15L >>> 32);
    }

    /** The next lot of the sequence. Source: W. Press and others, Numerical Recipes, 1992, 7.1. */
    public static int next(int lot) {
        return lot * 1664525 + 1013904223;
    }
}
