package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import radiosity.scene.ImageMap;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.setup.InitialMesh;
import radiosity.testkit.ColouredRoom;

/** A saved calculation goes on in the same scene only, even where all faces have the mean values that they had. */
class OtherSceneTest {

    private static final Scene SCENE = ColouredRoom.SCENE;
    private static final int WALL = SCENE.surfaceOf()[0];

    private static String fingerprint(Scene scene) {
        return new InitialMesh(scene, new RadiositySettings(SCENE.area() / 60, 1, Double.POSITIVE_INFINITY,
                Schedule.PREDICT)).fingerprint();
    }

    private static Scene scene(int[] surfaceOf, List<Surface> surfaces, float[] places) {
        return new Scene(SCENE.name(), SCENE.points(), SCENE.corners(), surfaceOf, surfaces, List.of(), SCENE.camera(),
                places);
    }

    /** Triangles of different surfaces share no vertices. */
    @Test
    void surfaceThatBecomesTwoEqualOnes_isAnotherScene() {
        List<Surface> surfaces = new ArrayList<>(SCENE.surfaces());
        surfaces.add(surfaces.get(WALL));
        int[] surfaceOf = SCENE.surfaceOf().clone();
        surfaceOf[0] = surfaces.size() - 1;
        assertEquals(fingerprint(SCENE), fingerprint(scene(SCENE.surfaceOf(), SCENE.surfaces(), new float[0])));
        assertNotEquals(fingerprint(SCENE), fingerprint(scene(surfaceOf, surfaces, new float[0])));
    }

    /** Left and right change places, so the mean over the wall stays. */
    @Test
    void imageWithTheSameMean_isAnotherScene() {
        assertNotEquals(fingerprint(painted(.9f, .1f)), fingerprint(painted(.1f, .9f)));
    }

    private static Scene painted(float left, float right) {
        Raster raster = new Raster(2, 1, new float[] {left, left, left, right, right, right}, ImageMap.Wrap.EDGE,
                ImageMap.Wrap.EDGE, Rgb.BLACK);
        List<Surface> surfaces = new ArrayList<>(SCENE.surfaces());
        surfaces.set(WALL, surfaces.get(WALL).with(new Surface.Maps(Optional.empty(), Optional.of(raster))));
        float[] places = new float[6 * SCENE.triangles()];
        for (int t = 0; t < SCENE.triangles(); t++) {
            float[] ofTriangle = {0, 0, 1, 0, .5f, 1};
            System.arraycopy(ofTriangle, 0, places, 6 * t, 6);
        }
        return scene(SCENE.surfaceOf(), surfaces, places);
    }
}
