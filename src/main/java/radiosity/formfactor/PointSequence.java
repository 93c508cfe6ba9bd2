package radiosity.formfactor;

/**
 * The R2 sequence: places in the unit square, of which any first few are spread evenly (M. Roberts, The unreasonable
 * effectiveness of quasirandom sequences, 2018).
 */
public final class PointSequence {

    private static final double STEP_U = 0.7548776662466927;
    private static final double STEP_V = 0.5698402909980532;

    private PointSequence() { }

    /** First coordinate of a place, from 0 to 1. */
    public static double u(double number) {
        return number * STEP_U % 1;
    }

    /** The second one. */
    public static double v(double number) {
        return number * STEP_V % 1;
    }
}
