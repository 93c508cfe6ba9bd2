package radiosity.testkit;

import radiosity.output.points.Points;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
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
        Points points = new Points(solution);
        double[] found = new double[places.length / 2];
        for (int i = 0; i < places.length / 6; i++) {
            Rgb b = points.at(vector(places, 6 * i), vector(places, 6 * i + 3)).radiosity();
            for (int c = 0; c < 3; c++) {
                found[3 * i + c] = b.channel(c);
            }
        }
        return found;
    }

    private static Vec3 vector(double[] v, int i) {
        return new Vec3(v[i], v[i + 1], v[i + 2]);
    }
}
