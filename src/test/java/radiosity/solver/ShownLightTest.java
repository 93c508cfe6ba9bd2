package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.solution.Solution;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/** What files and pictures show is the light that the elements have received. */
class ShownLightTest {

    /** Straight lines between the vertices lose .1 to .7 % where light is curved, and vertices show that. */
    @ParameterizedTest
    @ValueSource(doubles = {.02, .1})
    void irradianceOverAllElements_isTheFluxReceived(double accuracy) {
        Solution solution = Solve.byDefault().accurate(accuracy).solution(RoomScenes.withBlocks(
                RoomScenes.grey("wall", 0, .5), RoomScenes.grey("lamp", 10, .5)));
        double received = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int e = 0; e < solution.elements(); e++) {
            for (int k = 0; k < 3; k++) {
                double arriving = solution.irradianceAt(solution.corners()[3 * e + k]).r();
                received += area(solution, e) / 3 * arriving;
                least = Math.min(least, arriving);
            }
        }
        assertEquals(1, received / solution.ledger().received()[0], 1e-5);
        assertTrue(least >= 0, "least irradiance " + least);
    }

    private static double area(Solution solution, int element) {
        double[] x = solution.positions();
        int[] c = solution.corners();
        double[] a = new double[3];
        double[] b = new double[3];
        for (int i = 0; i < 3; i++) {
            a[i] = x[3 * c[3 * element + 1] + i] - x[3 * c[3 * element] + i];
            b[i] = x[3 * c[3 * element + 2] + i] - x[3 * c[3 * element] + i];
        }
        double nx = a[1] * b[2] - a[2] * b[1];
        double ny = a[2] * b[0] - a[0] * b[2];
        double nz = a[0] * b[1] - a[1] * b[0];
        return Math.sqrt(nx * nx + ny * ny + nz * nz) / 2;
    }
}
