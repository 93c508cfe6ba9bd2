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
 * @param meshError with prediction: see {@link Accuracy#meshError}; 0: that of the default accuracy
 * @param layers    whether the light of each lamp is kept in channels of its own
 * @param factors   way to compute form factors
 */
public record RadiositySettings(double patchArea, int rays, double meshing, Schedule schedule, double tolerance,
                                double meshError, boolean layers, FormFactors factors) {

    /** Largest number of lamps whose light can be kept apart. */
    public static final int MOST_LAMPS = 256;

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
     */
    public RadiositySettings accurate(double error) {
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
