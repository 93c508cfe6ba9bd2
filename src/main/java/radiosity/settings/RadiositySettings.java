package radiosity.settings;

/**
 * Fineness and exactness of a calculation. The same scene and settings give the same bits on all machines.
 *
 * @param patchArea largest area of a patch of the initial mesh, square scene units ({@code -pa}); 0: chosen by scene
 * @param rays      number of sample points for the visible share of a shooter, or of cells for projections
 *                  ({@code -nr}); 0: chosen by schedule and form factors
 * @param meshing   radiosity difference between an element's vertices above which the element is subdivided, W/m²
 *                  ({@code -mt}); infinite: never
 * @param schedule  order in which patches shoot
 * @param tolerance with prediction: see {@link Accuracy#tolerance}; 0: that of the default accuracy
 * @param meshError with prediction: see {@link Accuracy#meshError}; 0: that of the default accuracy;
 *                  infinite: elements are not divided for their errors
 * @param layers    whether the light of each lamp is kept in channels of its own
 * @param factors   way to compute form factors
 */
public record RadiositySettings(double patchArea, int rays, double meshing, Schedule schedule, double tolerance,
                                double meshError, boolean layers, FormFactors factors) {

    /** Largest number of lamps whose light can be kept apart. */
    public static final int MOST_LAMPS = 256;

    /** Largest number of rays: more take hours for a box. */
    public static final int MOST_RAYS = 1_000_000;

    /**
     * Checks all values.
     *
     * @throws IllegalArgumentException where a number is NaN or below 0, {@code patchArea} or {@code tolerance} is
     *                                  infinite, there are more rays than {@link #MOST_RAYS}, or schedule or form
     *                                  factors are null
     */
    public RadiositySettings {
        check("patch area", patchArea, Double.MAX_VALUE);
        check("rays", rays, MOST_RAYS);
        check("meshing threshold", meshing, Double.POSITIVE_INFINITY);
        check("tolerance", tolerance, Double.MAX_VALUE);
        check("mesh error", meshError, Double.POSITIVE_INFINITY);
        if (schedule == null || factors == null) {
            throw new IllegalArgumentException("settings: expected a schedule and form factors, got " + schedule
                    + " and " + factors);
        }
    }

    private static void check(String what, double value, double most) {
        if (!(value >= 0 && value <= most)) {
            throw new IllegalArgumentException("settings: expected a " + what + " from 0 to " + most + ", got "
                    + value);
        }
    }

    public RadiositySettings(double patchArea, int rays, double meshing, Schedule schedule, double tolerance,
                             double meshError) {
        this(patchArea, rays, meshing, schedule, tolerance, meshError, false, FormFactors.RAYCAST);
    }

    public RadiositySettings(double patchArea, int rays, double meshing, Schedule schedule) {
        this(patchArea, rays, meshing, schedule, 0, 0);
    }

    /** These settings with or without layers. */
    public RadiositySettings layers(boolean kept) {
        return new RadiositySettings(patchArea, rays, meshing, schedule, tolerance, meshError, kept, factors);
    }

    /** These settings with other form factors. */
    public RadiositySettings factors(FormFactors found) {
        return new RadiositySettings(patchArea, rays, meshing, schedule, tolerance, meshError, layers, found);
    }

    /**
     * These settings with the thresholds for an expected error.
     *
     * @param error expected error, above 0; see {@link Accuracy}
     * @throws IllegalArgumentException for any other number, or NaN
     */
    public RadiositySettings accurate(double error) {
        if (!(error > 0)) {
            throw new IllegalArgumentException("accuracy: expected an error above 0, got " + error);
        }
        return new RadiositySettings(patchArea, rays, meshing, schedule, Accuracy.tolerance(error),
                Accuracy.meshError(error), layers, factors);
    }

    /** These settings with the thresholds of others. */
    public RadiositySettings asAccurateAs(RadiositySettings other) {
        return new RadiositySettings(patchArea, rays, meshing, schedule, other.tolerance, other.meshError, layers,
                factors);
    }

    /** Whether these settings are made for a larger error than a given one, which is above 0. */
    public boolean isCoarserThan(double error) {
        return Accuracy.tolerance(error) < (tolerance == 0 ? Accuracy.tolerance(Accuracy.DEFAULT) : tolerance);
    }

    public static RadiositySettings defaults() {
        return new RadiositySettings(0, 0, Double.POSITIVE_INFINITY, Schedule.PREDICT);
    }
}
