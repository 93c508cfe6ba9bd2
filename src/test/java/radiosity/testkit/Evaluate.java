package radiosity.testkit;

import radiosity.edit.LightDifference;
import radiosity.solution.Solution;

/** A solution at many points at once. */
public final class Evaluate {

    private Evaluate() { }

    /**
     * Emitted and reflected radiosity.
     *
     * @param places x, y, z, nx, ny, nz per point; not modified
     * @return r, g, b per point, W/m²; NaN where there is no element
     */
    public static double[] radiosity(Solution solution, double[] places) {
        return LightDifference.radiosity(solution, places);
    }
}
