package radiosity.world;

/**
 * How finely and how exactly to compute. Equal settings give equal bits on any machines.
 *
 * @param patchArea   no patch of the initial mesh is larger, square scene units ({@code -pa}); 0: chosen from the scene
 * @param rays        sample points for the visible share of a shooter, at least 1 ({@code -nr})
 * @param meshing     radiosity difference between an element's vertices above which it is subdivided, W/m²
 *                    ({@code -mt}); infinite: never
 * @param schedule    in which order patches shoot
 */
public record RadiositySettings(double patchArea, int rays, double meshing, Schedule schedule) {

    public static RadiositySettings defaults() {
        return new RadiositySettings(0, 4, Double.POSITIVE_INFINITY, Schedule.PAPER);
    }
}
