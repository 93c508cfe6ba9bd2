package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import radiosity.output.gltf.Handmade;
import radiosity.output.gltf.LitScene;
import radiosity.output.image.DefaultCamera;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;

/** Walls and elements under the mouse: what is seen, from the side from which it is seen. */
class ObstaclesTest {

    private static final Vec3 X = new Vec3(1, 0, 0);
    private static final Vec3 Y = new Vec3(0, 1, 0);
    private static final Vec3 Z = new Vec3(0, 0, 1);

    private final Handmade made = new Handmade();

    /** A unit square in a plane of constant z, seen from +z or from -z. */
    private void square(String name, double z, boolean isFront) {
        made.grid(made.surface(name, .5), new Vec3(0, 0, z), isFront ? X : Y, isFront ? Y : X, 1, 1, p -> Rgb.grey(1));
    }

    private Obstacles obstacles() {
        Solution solution = made.solution();
        return new Obstacles(LitScene.of(solution, DefaultCamera.of(solution)));
    }

    private static double distance(Obstacles obstacles, double z, Vec3 direction) {
        Optional<Obstacles.Hit> hit = obstacles.hit(new Vec3(.3, .4, z), direction, 10);
        hit.ifPresent(h -> assertEquals(-1, h.normal().dot(direction), 1e-9));
        return hit.map(Obstacles.Hit::distance).orElse(Double.NaN);
    }

    /** The back of its one side lies in the place of the front of the other. */
    @Test
    void sheet_isMetFromBothSides() {
        square("front", 0, true);
        square("back", 0, false);
        Obstacles sheet = obstacles();
        assertEquals(2, distance(sheet, 2, Z.times(-1)), 1e-5);
        assertEquals(3, distance(sheet, -3, Z), 1e-5);
    }

    @Test
    void backs_areSeenThrough() {
        square("wall", 0, true);
        for (int i = 1; i <= 40; i++) {
            square("back " + i, i / 40.0, false);
        }
        Obstacles wall = obstacles();
        assertEquals(2, distance(wall, 2, Z.times(-1)), 1e-5);
        assertEquals(1 + 1 / 40.0, distance(wall, -1, Z), 1e-5);
        assertEquals(Double.NaN, distance(wall, 1.5, Z));
    }
}
