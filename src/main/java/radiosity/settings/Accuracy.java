package radiosity.settings;

/**
 * How exactly to calculate, as one number: the error that is expected of the radiosity, area-weighted root mean square
 * over the mean. What follows from it was measured on other scenes ({@code scripts/accuracy --accuracy}); each
 * solution's certificate says what was reached.
 */
public final class Accuracy {

    /** What is aimed at where nothing is asked for. */
    public static final double DEFAULT = 0.02;
    /**
     * So many times the mean radiosity is bright: where there is more, errors are relative to this part of what is
     * there. A lampshade is hundreds of times as bright as its room, and a hundredth of that is no error of several
     * means.
     */
    public static final double BRIGHT = 3;
    /** At that: what one ray may carry, relative to the mean, and what interpolation on one element may add. */
    private static final double TOLERANCE = 0.028;
    private static final double MESH_ERROR = 8e-4;
    /** What a ray may carry falls faster than the error, as sampling and meshing each leave their part of it. */
    public static final double POWER = 1.25;
    /** Elements too, as a small one may be far off at a point without adding much to the whole. */
    private static final double MESH_POWER = 2;

    private Accuracy() { }

    /** @param error above 0 */
    public static double tolerance(double error) {
        return TOLERANCE * StrictMath.pow(error / DEFAULT, POWER);
    }

    /** The error that is expected at a tolerance; 0 stands for the default. */
    public static double of(double tolerance) {
        return tolerance == 0 ? DEFAULT : DEFAULT * StrictMath.pow(tolerance / TOLERANCE, 1 / POWER);
    }

    /** @param error above 0 */
    public static double meshError(double error) {
        return MESH_ERROR * StrictMath.pow(error / DEFAULT, MESH_POWER);
    }
}
