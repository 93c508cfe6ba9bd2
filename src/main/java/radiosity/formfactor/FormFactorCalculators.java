package radiosity.formfactor;

import java.util.Arrays;
import java.util.function.DoubleFunction;
import radiosity.mesh.Patcher;
import radiosity.settings.FormFactors;
import radiosity.visibility.RadiosityBounds;

/** Makes the calculator for each kind of form factors in {@link FormFactors}. */
public final class FormFactorCalculators {

    private FormFactorCalculators() { }

    /**
     * Makes a calculator, which any number of threads may use.
     *
     * @param bounds    the triangles that cast shadows
     * @param rays      number of sample points per node, or of cells along an edge of a projection; at least 1
     * @param tolerance largest weighted irradiance of one ray, see {@link RayCaster}; the other calculators ignore it
     */
    public static FormFactorCalculator make(FormFactors kind, RadiosityBounds bounds, int rays, double tolerance) {
        return switch (kind) {
            case RAYCAST -> new RayCaster(bounds, rays, tolerance);
            case PLAIN -> new PlainRays(bounds, rays);
            case HEMICUBE -> new Hemicube(bounds, rays);
            case NUSSELT -> new Nusselt(bounds, rays);
        };
    }

    /**
     * One calculator per value of {@link Patcher#slack}: each further one lets a ray carry twice as much.
     *
     * @param tolerance of the first calculator
     * @param maker     makes a calculator with a given tolerance
     */
    public static FormFactorCalculator[] perSlack(double tolerance, DoubleFunction<FormFactorCalculator> maker) {
        FormFactorCalculator[] made = new FormFactorCalculator[Patcher.MOST_SLACK + 1];
        Arrays.setAll(made, slack -> maker.apply(tolerance * (1 << slack)));
        return made;
    }

    /** Number of rays, or of cells of a projection, where the user gives none. */
    public static int defaultRays(FormFactors kind, int raysOfRayCaster) {
        return switch (kind) {
            case RAYCAST, PLAIN -> raysOfRayCaster;
            case HEMICUBE -> Hemicube.DEFAULT_CELLS;
            case NUSSELT -> Nusselt.DEFAULT_CELLS;
        };
    }
}
