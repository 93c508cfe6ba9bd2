package radiosity.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

class VertexBulgeTest {

    /** A plate above a floor in the sun: what is in the shade has the light of the sky, whatever the mesh is. */
    @Test
    void shadeBesideTheSun_isNotBlack() {
        SceneBuilder builder = new SceneBuilder();
        builder.polygon(RoomScenes.grey("floor", 0, .2), new Vec3(0, 0, 0), new Vec3(0, 0, 6), new Vec3(6, 0, 6),
                new Vec3(6, 0, 0));
        RoomScenes.addSolid(builder, RoomScenes.grey("plate", 0, .2), new Vec3(2.1, 1, 2.2), new Vec3(3.8, 1.1, 3.9));
        builder.light(Light.sun(new Vec3(.3, 1, .4), 50_000))
                .light(Light.sky(Light.Kind.SKY_UNIFORM, 1000, new Vec3(0, 1, 0), Vec3.ZERO));
        Solution solution = Solve.byDefault().accurate(.2).solution(builder.scene("plate"));
        int floor = 0;
        for (int e = 0; e < solution.elements(); e++) {
            for (int k = 0; k < 3 && solution.faceOf()[e] < 4; k++) {
                Rgb light = solution.irradianceAt(solution.corners()[3 * e + k]);
                assertTrue(light.r() > 200, "got " + light);
                assertEquals(light.r(), light.b(), 1e-9 * light.r());
                floor++;
            }
        }
        assertTrue(floor > 100, "vertices of the floor: " + floor);
    }
}
