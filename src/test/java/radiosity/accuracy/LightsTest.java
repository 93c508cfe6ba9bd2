package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.solution.Solution;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/**
 * Sources without geometry against closed form, to 0.1 %, on a black square of 4 x 4 in the plane y = 0, seen from
 * above, whose vertices lie at multiples of 1/16: what vertices show beyond the light there, for straight lines between
 * them to carry as much as arrives, is below 0.03 %.
 *
 * <p>Point: E = I cos / d^2 = I h / d^3. CIE 171:2006, 5.2, has I = 1000 cd at h = 3 m, but a source that is Lambertian
 * itself: E = I h^2 / d^4. LightWave's is the same in all directions, so its E is that times d / h. Distant: E = cos.
 * Area: CIE 171:2006, 5.3, a Lambertian square of 1 x 1 with M = 1000 pi at h = 3 m; values by the contour sum, as in
 * CieCase.
 */
class LightsTest {

    private static Solution lit(Light light) {
        Scene square = new SceneBuilder()
                .polygon(RoomScenes.grey("square", 0, 0), new Vec3(-2, 0, -2), new Vec3(-2, 0, 2),
                new Vec3(2, 0, 2), new Vec3(2, 0, -2)).scene("square");
        Scene scene = new Scene("lit square", square.points(), square.corners(), square.surfaceOf(), square.surfaces(),
                List.of(light), Optional.empty());
        RadiositySettings defaults = RadiositySettings.defaults();
        return new Solve(new RadiositySettings(0.0025, 1, defaults.meshing(), defaults.schedule()),
                Solve.byDefault().stop(), 1).solution(scene);
    }

    private static Light light(Light.Kind kind, double power, double cone, double edge) {
        return new Light("light", kind, Rgb.grey(power), new Vec3(0, 3, 0), new Vec3(0, -1, 0), new Vec3(0.5, 0, 0),
                new Vec3(0, 0, 0.5), 1, cone, edge);
    }

    /** Irradiance at a vertex of the mesh. */
    private static double at(Solution solution, double x, double z) {
        for (int v = 0; v < solution.vertices(); v++) {
            if (solution.positions()[3 * v] == x && solution.positions()[3 * v + 2] == z) {
                return solution.irradiance()[v];
            }
        }
        throw new AssertionError("no vertex at " + x + ", " + z);
    }

    @Test
    void pointLight_isCie52WithoutItsSourcesCosine() {
        Solution solution = lit(light(Light.Kind.POINT, 1000, 0, 0));
        double[][] points = {{0, 0, 111.1111}, {.5, 0, 105.1863}, {1, 0, 90.0000}, {1.5, 0, 71.1111},
            {.5, .5, 99.7230}, {1, .5, 85.6633}, {1.5, .5, 68.0529}, {1, 1, 74.3802}, {1.5, 1, 59.9750},
            {1.5, 1.5, 49.3827}};
        for (double[] p : points) {
            double expected = p[2] * Math.sqrt(9 + p[0] * p[0] + p[1] * p[1]) / 3;
            assertEquals(expected, at(solution, p[0], p[1]), 1e-3 * expected);
        }
    }

    @Test
    void spotLight_isAPointLightWithinItsCone() {
        double cone = StrictMath.atan2(1.25, 3);
        Solution spot = lit(light(Light.Kind.SPOT, 1000, cone, 0));
        assertEquals(1000 * 3 / Math.pow(10, 1.5), at(spot, 1, 0), 0.09);
        assertEquals(0, at(spot, 1.5, 0), 0);
        Solution soft = lit(light(Light.Kind.SPOT, 1000, cone, 2 * (cone - StrictMath.atan2(1, 3))));
        assertEquals(1000 * 3 / Math.pow(10, 1.5) / 2, at(soft, 1, 0), 0.045);
    }

    @Test
    void distantLight_fallsWithTheCosine() {
        Light straight = light(Light.Kind.DISTANT, 2, 0, 0);
        Light slanted = new Light("sun", Light.Kind.DISTANT, Rgb.grey(2), Vec3.ZERO, new Vec3(0.6, -0.8, 0), Vec3.ZERO,
                Vec3.ZERO, 1, 0, 0);
        assertEquals(2, at(lit(straight), 0.5, 0.5), 1e-6);
        assertEquals(1.6, at(lit(slanted), 0.5, 0.5), 1e-6);
    }

    @Test
    void areaLight_isCie53() {
        Solution solution = lit(light(Light.Kind.AREA, 1000 * Math.PI, 0, 0));
        double[] floor = {61.4241, 79.2552, 95.6673, 105.7782};
        for (int i = 0; i < 4; i++) {
            assertEquals(floor[i], at(solution, 0, -1.75 + 0.5 * i), 1e-3 * floor[i]);
        }
    }

    @Test
    void ledger_closesWithLights() {
        Solution solution = lit(light(Light.Kind.POINT, 1000, 0, 0));
        assertTrue(solution.ledger().emitted()[0] > 0);
        assertEquals(0, solution.ledger().imbalance(0), 1e-12);
    }
}
