package radiosity.formfactor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import radiosity.mesh.face.Faces;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;

/**
 * Before the middle of a side of a cube, the opposite side fills four rectangles of half its width at the distance 1:
 * 4 / pi * x atan x with x = .5 / sqrt(1 + .5 * .5), so .23943 (J. R. Howell, A catalog of radiation configuration
 * factors, 1982, B-3).
 */
class EscapingShareTest {

    /** The first and the last are opposite. */
    private static final int[] ORDER = {0, 2, 3, 4, 5, 1};

    private static double mean(Scene scene) {
        Faces faces = new Faces(scene);
        EscapingLight escaping = EscapingLightTest.of(faces);
        double sum = 0;
        for (int i = 0; i < 1000; i++) {
            sum += escaping.share(middle(faces), 0, i) / 1000;
        }
        return sum;
    }

    /** Of the first side, which is two triangles. */
    private static float[] middle(Faces faces) {
        float[] x = new float[3];
        for (int a = 0; a < 3; a++) {
            for (int k = 0; k < 3; k++) {
                x[a] += (faces.corner(0, k, a) + faces.corner(1, k, a)) / 6;
            }
        }
        return x;
    }

    private static Scene cube(int sides) {
        SceneBuilder builder = new SceneBuilder();
        for (int side = 0; side < sides; side++) {
            builder.polygon(RoomScenes.grey("wall", 1, 0.5), Box.UNIT.inside(ORDER[side]));
        }
        return builder.scene("cube");
    }

    @Test
    void closedRoom_losesNothing() {
        assertEquals(0, mean(cube(6)));
    }

    @Test
    void missingWall_takesItsFormFactor() {
        assertEquals(0.23943, mean(cube(5)), 0.003);
    }
}
