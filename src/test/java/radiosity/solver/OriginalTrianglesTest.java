package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/** The calculation cuts long quadrangles, and edges at corners of others; who reads a solution does not see that. */
class OriginalTrianglesTest {

    /** A corridor three times as long as wide, beside a shelf whose corners lie on edges of the walls. */
    private static Scene corridor() {
        SceneBuilder builder = new SceneBuilder();
        RoomScenes.addRoom(builder, RoomScenes.grey("wall", 0, .5), new Box(Vec3.ZERO, new Vec3(6, 2, 2)));
        return builder.polygon(RoomScenes.grey("lamp", 9, 0), new Vec3(2, 1.9, .5), new Vec3(5, 1.9, .5),
                        new Vec3(5, 1.9, 1.5), new Vec3(2, 1.9, 1.5))
                .polygon(RoomScenes.grey("shelf", 0, .5), new Vec3(1, 0, 2), new Vec3(2, 0, 1), new Vec3(2, 0, 2))
                .scene("corridor");
    }

    @Test
    void elements_nameTrianglesOfTheScene() throws IOException {
        Scene scene = corridor();
        Solution solution = Solve.byDefault().accurate(.2).solution(scene);
        assertSame(scene, solution.scene());
        boolean[] isMet = new boolean[scene.triangles()];
        for (int e = 0; e < solution.elements(); e++) {
            int t = solution.faceOf()[e] >> 1;
            isMet[t] = true;
            Vec3 middle = Vec3.ZERO;
            for (int k = 0; k < 3; k++) {
                int v = 3 * solution.corners()[3 * e + k];
                middle = middle.plus(new Vec3(solution.positions()[v], solution.positions()[v + 1],
                        solution.positions()[v + 2]).times(1.0 / 3));
            }
            double height = middle.minus(scene.corner(t, 0)).dot(scene.cross(t).unit());
            assertEquals(0, height, 1e-9, "element at " + middle + " is not in the plane of triangle " + t);
        }
        for (int t = 0; t < isMet.length; t++) {
            assertTrue(isMet[t], "no element names triangle " + t);
        }
    }
}
