package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.output.points.Points;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.testkit.SharedData;
import radiosity.testkit.Solve;

/**
 * How fast errors fall. Radiosity is linear on an element, so with a uniform mesh of h wide elements the error falls
 * with h^2 where radiosity is smooth; along the edges of a room it is continuous but its slope is not bounded, and what
 * is gained there is less. Asked for is h^1 at least: half the error for four times the elements. Convex room: no
 * visibility to sample, and the paper's schedule, in which no other parameter follows the light.
 */
@Tag("slow")
class ConvergenceTest {

    @Test
    void error_fallsAtLeastWithTheWidthOfElements() {
        double coarse = error(48);
        double middle = error(192);
        double fine = error(768);
        assertTrue(middle <= 0.5 * coarse, () -> coarse + ", " + middle);
        assertTrue(fine <= 0.5 * middle, () -> middle + ", " + fine);
    }

    /** Root of the mean squared error in red over the points of a known solution, W/m². */
    private static double error(int patches) {
        JsonNode known = SharedData.find("enclosures.json", "cube-ceiling");
        Scene room = SharedData.scene("cube", known.get("surfaces"));
        Solution solution = Solve.byDefault().paper().patches(room, patches).unsent(1e-5).solution(room);
        Points points = new Points(solution);
        double squares = 0;
        JsonNode all = known.get("continuous").get("points");
        for (JsonNode p : all) {
            Vec3 normal = FormFactorsTest.normal(SharedData.polygon(
                    known.get("surfaces").get(p.get("surface").asInt()).get("vertices")));
            Rgb found = points.at(SharedData.vector(p.get("x")), normal).radiosity();
            squares += Math.pow(found.r() - p.get("B").get(0).asDouble(), 2);
        }
        return Math.sqrt(squares / all.size());
    }
}
