package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.solution.Solution;
import radiosity.testkit.Cells;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/**
 * The rendering equation is linear in emission: B(a E1 + b E2) = a B(E1) + b B(E2), and every channel is a calculation
 * of its own. With the paper's schedule the discrete system is linear too, as its form factors do not depend on what is
 * shot; only what is left unshot differs from run to run, 1e-7 here. With prediction, mesh and rays follow the light.
 */
@Tag("slow")
class LinearityTest {

    private static final double TOLERANCE = 2e-6;

    private static Solution solution(double first, double second) {
        Surface wall = RoomScenes.grey("wall", 0, 0.5);
        Surface left = RoomScenes.grey("left lamp", first, 0.2);
        Surface right = RoomScenes.grey("right lamp", second, 0.4);
        double[] planes = {0, 1, 2, 3};
        Scene room = new Cells(planes, planes, planes).room("two lamps", (i, j, k) -> i != 1 || j != 0 || k != 1,
                (i, j, k, side) -> side == 3 && k == 1 ? i == 0 ? left : i == 2 ? right : wall : wall);
        return Solve.byDefault().paper().patches(room, 60).unsent(1e-7).solution(room);
    }

    @Test
    void twoLamps_giveTheSumOfEach() {
        double[] first = solution(3, 0).irradiance();
        double[] second = solution(0, 1).irradiance();
        double[] both = solution(3, 1).irradiance();
        double largest = Arrays.stream(both).max().orElseThrow();
        for (int v = 0; v < both.length; v++) {
            assertEquals(first[v] + second[v], both[v], TOLERANCE * largest);
        }
    }

    @Test
    void brighterLamp_givesMoreInProportion() {
        double[] dim = solution(1e-30, 0).irradiance();
        double[] bright = solution(1e30, 0).irradiance();
        double largest = Arrays.stream(dim).max().orElseThrow();
        for (int v = 0; v < dim.length; v++) {
            assertEquals(dim[v], bright[v] * 1e-60, TOLERANCE * largest);
        }
    }

    @Test
    void channel_isThatOfTheSceneInGrey() {
        Scene coloured = RoomScenes.withBlocks(new Surface("wall", new Rgb(3, 1, 2), new Rgb(0.1, 0.5, 0.3), false));
        Scene grey = RoomScenes.withBlocks(RoomScenes.grey("wall", 1, 0.5));
        Solve solve = Solve.byDefault().paper().patches(grey, 60).unsent(1e-7);
        Solution all = solve.solution(coloured);
        Solution green = solve.solution(grey);
        double largest = Arrays.stream(green.irradiance()).max().orElseThrow();
        for (int v = 0; v < green.vertices(); v++) {
            assertEquals(green.irradiance()[v], all.irradianceAt(v).g(), TOLERANCE * largest);
        }
    }
}
