package radiosity.settings;

/**
 * How finely and how exactly to compute. Equal settings give equal bits on any machines.
 *
 * @param patchArea no patch of the initial mesh is larger, square scene units ({@code -pa}); 0: chosen from the scene
 * @param rays      sample points for the visible share of a shooter ({@code -nr}); 0: chosen by the schedule
 * @param meshing   radiosity difference between an element's vertices above which it is subdivided, W/m²
 *                  ({@code -mt}); infinite: never
 * @param schedule  in which order patches shoot
 * @param tolerance with prediction: irradiance that one ray may carry, relative to the mean; 0: chosen
 * @param meshError with prediction: error of interpolation that one element may add to the whole; 0: chosen
 * @param layers    whether the light of each lamp is kept apart
 * @param factors   how form factors are found
 */
public record RadiositySettings(double patchArea, int rays, double meshing, Schedule schedule, double tolerance,
                                double meshError, boolean layers, FormFactors factors) {

    /** The number of lamps whose light can be kept apart. */
    public static final int MOST_LAMPS = 256;

    public RadiositySettings(double patchArea, int rays, double meshing, Schedule schedule, double tolerance,
                             double meshError) {
        this(patchArea, rays, meshing, schedule, tolerance, meshError, false, FormFactors.RAYCAST);
    }

    public RadiositySettings(double patchArea, int rays, double meshing, Schedule schedule) {
        this(patchArea, rays, meshing, schedule, 0, 0);
    }

    /** The same, with or without layers. */
    public RadiositySettings layers(boolean kept) {
        return new RadiositySettings(patchArea, rays, meshing, schedule, tolerance, meshError, kept, factors);
    }

    /** The same, with other form factors. */
    public RadiositySettings factors(FormFactors found) {
        return new RadiositySettings(patchArea, rays, meshing, schedule, tolerance, meshError, layers, found);
    }

    /**
     * The same with what an accuracy asks for.
     *
     * @param error that is expected, above 0; see {@link Accuracy}
     */
    public RadiositySettings accurate(double error) {
        return new RadiositySettings(patchArea, rays, meshing, schedule, Accuracy.tolerance(error),
                Accuracy.meshError(error), layers, factors);
    }

    public static RadiositySettings defaults() {
        return new RadiositySettings(0, 0, Double.POSITIVE_INFINITY, Schedule.PREDICT);
    }
}
