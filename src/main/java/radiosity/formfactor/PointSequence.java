package radiosity.formfactor;

/**
 * The R2 sequence: a low-discrepancy sequence of points in the unit square (M. Roberts, The unreasonable effectiveness
 * of quasirandom sequences, 2018).
 */
public final class PointSequence {

    private static final double STEP_U = 0.7548776662466927;
    private static final double STEP_V = 0.5698402909980532;

    private PointSequence() { }

    /** First coordinate, in [0, 1), of the point with this number, which is 0 or more. */
    public static double u(double number) {
        return number * STEP_U % 1;
    }

    /** Second coordinate, in [0, 1), of the point with this number, which is 0 or more. */
    public static double v(double number) {
        return number * STEP_V % 1;
    }
}
