package radiosity.edit;

import java.util.Arrays;
import java.util.stream.IntStream;
import radiosity.output.points.Points;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.settings.Accuracy;
import radiosity.solution.Certificate;
import radiosity.solution.Solution;
import radiosity.util.R2;

/** Compares the light of two solutions of one scene at points spread over its surfaces. */
public final class LightDifference {

    /** Number of values per point: position and normal. */
    private static final int PER_PLACE = 6;

    private LightDifference() { }

    /** Returns points spread evenly over all visible sides that do not emit: x, y, z, nx, ny, nz; scene units. */
    public static double[] places(Scene scene, int count) {
        double[] upTo = new double[scene.triangles()];
        double sum = 0;
        for (int t = 0; t < upTo.length; t++) {
            sum += scene.surface(t).emits() ? 0 : scene.area(t) * (scene.surface(t).twoSided() ? 2 : 1);
            upTo[t] = sum;
        }
        double[] places = new double[PER_PLACE * count];
        for (int i = 0; i < count; i++) {
            double at = (i + 0.5) / count * sum;
            int t = Arrays.binarySearch(upTo, at);
            t = Math.min(upTo.length - 1, t < 0 ? -1 - t : t);
            double u = (0.5 + R2.u(i)) % 1;
            double v = (0.5 + R2.v(i)) % 1;
            double r = Math.sqrt(u);
            Vec3 a = scene.corner(t, 0);
            Vec3 p = a.plus(scene.corner(t, 1).minus(a).times(r * (1 - v)))
                    .plus(scene.corner(t, 2).minus(a).times(r * v));
            Vec3 n = scene.cross(t).unit().times(scene.surface(t).twoSided() && i % 2 == 1 ? -1 : 1);
            for (int k = 0; k < 3; k++) {
                places[PER_PLACE * i + k] = p.coordinate(k);
                places[PER_PLACE * i + 3 + k] = n.coordinate(k);
            }
        }
        return places;
    }

    /**
     * Returns the emitted and reflected radiosity at points.
     *
     * @param places as {@link #places} returns them; not modified
     * @return r, g, b per point, W/m²; NaN where there is no element
     */
    public static double[] radiosity(Solution solution, double[] places) {
        Points points = new Points(solution);
        double[] found = new double[places.length / 2];
        for (int i = 0; i < found.length; i += 3) {
            Rgb b = points.at(new Vec3(places[2 * i], places[2 * i + 1], places[2 * i + 2]),
                    new Vec3(places[2 * i + 3], places[2 * i + 4], places[2 * i + 5])).radiosity();
            for (int c = 0; c < 3; c++) {
                found[i + c] = b.channel(c);
            }
        }
        return found;
    }

    /**
     * Returns the root mean square difference, relative as in {@link Certificate#expected}: at each point to the larger
     * of the mean radiosity and a third of the point's radiosity.
     *
     * @param expected r, g, b per point, W/m²; points with NaN in either array are left out
     * @return NaN where a colour has no points left
     */
    public static double of(double[] expected, double[] got) {
        double squares = 0;
        for (int c = 0; c < 3; c++) {
            int channel = c;
            int[] at = IntStream.range(0, expected.length).filter(i -> i % 3 == channel
                    && !Double.isNaN(expected[i]) && !Double.isNaN(got[i])).toArray();
            double mean = IntStream.of(at).mapToDouble(i -> expected[i]).average().orElse(Double.NaN);
            squares += IntStream.of(at)
                    .mapToDouble(i -> (expected[i] - got[i]) / Math.max(mean, expected[i] / Accuracy.BRIGHT))
                    .map(x -> x * x).average().orElse(Double.NaN) / 3;
        }
        return Math.sqrt(squares);
    }
}
