package radiosity.accuracy;

import java.util.List;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;

/**
 * A test case of CIE 171:2006, Test cases to assess the accuracy of lighting computer programs: its geometry, with
 * references of our own.
 *
 * @param name   as in the report, with the variant
 * @param scene  x to the right, y deep, z up, m; origin at a floor corner
 * @param points where irradiance is measured
 */
record CieCase(String name, Scene scene, List<Measured> points) {

    /**
     * A measuring point.
     *
     * @param name       its letter in the report
     * @param position   m
     * @param normal     of the surface on which it lies
     * @param irradiance exact, in W/m² (lx where the lamps are given in lm)
     */
    record Measured(String name, Vec3 position, Vec3 normal, double irradiance) { }

    /** The largest value of the case: what errors are quoted in. */
    double largest() {
        return points.stream().mapToDouble(Measured::irradiance).max().orElseThrow();
    }

    Measured point(String letter) {
        return points.stream().filter(p -> p.name().equals(letter)).findFirst().orElseThrow();
    }

    @Override
    public String toString() {
        return name;
    }
}
