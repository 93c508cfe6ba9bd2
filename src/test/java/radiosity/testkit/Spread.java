package radiosity.testkit;

import java.util.function.Predicate;
import java.util.function.ToDoubleBiFunction;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;

/**
 * Mean and extremes of a quantity over the surfaces of a solution.
 *
 * @param mean over the area of all elements whose middle is open to the room
 * @param low  smallest value at an open corner or middle of an element
 * @param high largest
 */
public record Spread(double mean, double low, double high) {

    /** A channel's radiosity, W/m². */
    public static Spread radiosity(Solution solution, int channel) {
        return of(solution, p -> true, (e, k) -> solution.radiosityAt(e, k).channel(channel));
    }

    /** A channel's irradiance, W/m². */
    public static Spread irradiance(Solution solution, int channel) {
        return of(solution, p -> true,
                (e, k) -> solution.irradianceAt(solution.corners()[3 * e + k]).channel(channel));
    }

    /**
     * @param open  false for points that are hidden behind another surface
     * @param value of corner k of an element
     */
    public static Spread of(Solution solution, Predicate<Vec3> open, ToDoubleBiFunction<Integer, Integer> value) {
        double sum = 0;
        double area = 0;
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int e = 0; e < solution.elements(); e++) {
            Vec3[] p = {corner(solution, e, 0), corner(solution, e, 1), corner(solution, e, 2)};
            double middle = 0;
            for (int k = 0; k < 3; k++) {
                double v = value.applyAsDouble(e, k);
                middle += v / 3;
                low = open.test(p[k]) ? Math.min(low, v) : low;
                high = open.test(p[k]) ? Math.max(high, v) : high;
            }
            if (open.test(p[0].plus(p[1]).plus(p[2]).times(1. / 3))) {
                double a = p[1].minus(p[0]).cross(p[2].minus(p[0])).length();
                sum += a * middle;
                area += a;
                low = Math.min(low, middle);
                high = Math.max(high, middle);
            }
        }
        return new Spread(sum / area, low, high);
    }

    private static Vec3 corner(Solution solution, int element, int k) {
        int p = 3 * solution.corners()[3 * element + k];
        return new Vec3(solution.positions()[p], solution.positions()[p + 1], solution.positions()[p + 2]);
    }
}
