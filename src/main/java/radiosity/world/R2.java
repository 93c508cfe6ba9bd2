package radiosity.world;

/**
 * The R2 sequence: places in the unit square, of which any first few are spread evenly (M. Roberts, The unreasonable
 * effectiveness of quasirandom sequences, 2018).
 */
final class R2 {

    private static final double STEP_U = 0.7548776662466927;
    private static final double STEP_V = 0.5698402909980532;

    private R2() { }

    /** First coordinate of a place, from 0 to 1. */
    static double u(double number) {
        return number * STEP_U % 1;
    }

    /** The second one. */
    static double v(double number) {
        return number * STEP_V % 1;
    }
}
