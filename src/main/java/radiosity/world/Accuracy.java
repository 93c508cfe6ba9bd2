package radiosity.world;

/**
 * How exactly to calculate, as one number: the error that is expected of the radiosity, area-weighted root mean square
 * over the mean. What follows from it was measured on other scenes ({@code scripts/accuracy --accuracy}); each solution's
 * certificate says what was reached.
 */
public final class Accuracy {

    /** What is aimed at where nothing is asked for. */
    public static final double DEFAULT = 0.02;
    /** At that: what one ray may carry, relative to the mean, and what interpolation on one element may add. */
    private static final double TOLERANCE = 0.045;
    private static final double MESH_ERROR = 2.5e-4;

    private Accuracy() { }

    /** @param error above 0 */
    static double tolerance(double error) {
        return TOLERANCE * error / DEFAULT;
    }

    /** The error that is expected at a tolerance; 0 stands for the default. */
    public static double of(double tolerance) {
        return tolerance == 0 ? DEFAULT : DEFAULT * tolerance / TOLERANCE;
    }

    /**
     * An element's part in the error falls with its number's root, and its number with the error.
     *
     * @param error above 0
     */
    static double meshError(double error) {
        double part = error / DEFAULT;
        return MESH_ERROR * part * Math.sqrt(part);
    }
}
