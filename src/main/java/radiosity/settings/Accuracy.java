package radiosity.settings;

/**
 * Converts the error that a user asks for into the thresholds for rays and elements with which a calculation begins.
 * The error is that of the radiosity: area-weighted root mean square relative to the mean. The constants and powers are
 * a guess from boxes of walls ({@code scripts/accuracy --accuracy}): points that look at each solution measure the
 * error, and the solver's {@code AccuracyLoop} lowers the thresholds until it is the one asked for.
 */
public final class Accuracy {

    /** Error where the user asks for none. */
    public static final double DEFAULT = 0.02;
    /**
     * Ratio to the mean radiosity above which a radiosity is bright: its errors are relative to the radiosity divided
     * by this number instead of the mean. A lampshade is hundreds of times as bright as its room, and an error of a
     * hundredth of its radiosity is not to count as several means.
     */
    public static final double BRIGHT = 3;
    /** Thresholds at the default error, see {@link #tolerance} and {@link #meshError}. */
    private static final double TOLERANCE = 0.028;
    private static final double MESH_ERROR = 8e-4;
    /** Power of the error in {@link #tolerance}: above 1, as sampling and meshing each cause a part of the error. */
    public static final double POWER = 1.25;
    /** Power of the error in {@link #meshError}: small elements may err by much at a point and add little in all. */
    private static final double MESH_POWER = 2;

    private Accuracy() { }

    /**
     * Largest light that the rays at one node may carry, relative to the mean radiosity.
     *
     * @param error expected error, above 0
     */
    public static double tolerance(double error) {
        return TOLERANCE * StrictMath.pow(error / DEFAULT, POWER);
    }

    /** Expected error at a tolerance of at least 0; 0 stands for the default. The inverse of {@link #tolerance}. */
    public static double of(double tolerance) {
        return tolerance == 0 ? DEFAULT : DEFAULT * StrictMath.pow(tolerance / TOLERANCE, 1 / POWER);
    }

    /**
     * Largest error of interpolation on one element, relative to the mean, times the root of its share of area.
     *
     * @param error expected error, above 0
     */
    public static double meshError(double error) {
        return MESH_ERROR * StrictMath.pow(error / DEFAULT, MESH_POWER);
    }
}
