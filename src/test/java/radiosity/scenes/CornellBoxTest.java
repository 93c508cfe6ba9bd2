package radiosity.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.Camera;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;

class CornellBoxTest {

    private static final String FULL = "cornell-box.lws";
    private static final String EMPTY = "cornell-box-empty.lws";

    @Test
    void camera_standsAndLooksAsPublished() throws IOException {
        Camera camera = ShippedScenes.read(FULL).camera().orElseThrow();
        assertEquals(new Vec3(278, 273, 800), camera.position());
        assertEquals(0, camera.forward().minus(new Vec3(0, 0, -1)).length(), 1e-12);
        assertEquals(0.0125 / 0.035, Math.tan(camera.verticalHalfAngle()), 1e-9);
        assertEquals(1, camera.aspect(), 1e-9);
    }

    @Test
    void camera_seesRedAtItsLeftAndGreenAtItsRight() throws IOException {
        Scene scene = ShippedScenes.read(FULL);
        assertTrue(toTheRight(scene, "red") < -250);
        assertTrue(toTheRight(scene, "green") > 250);
    }

    /** How far right of the camera's axis the first triangle of a surface lies, mm. */
    private static double toTheRight(Scene scene, String surface) {
        Camera camera = scene.camera().orElseThrow();
        Vec3 right = camera.forward().cross(camera.up());
        int t = 0;
        while (!scene.surface(t).name().equals(surface)) {
            t++;
        }
        return right.dot(scene.corner(t, 0).minus(camera.position()));
    }

    /** Worked out from the published corners. */
    @Test
    void areas_areThoseOfThePublishedCorners() throws IOException {
        Scene scene = ShippedScenes.read(EMPTY);
        double floor = (552.8 + 549.6) / 2 * 559.2;
        double back = (549.6 + 556.0) / 2 * 548.8;
        double ceiling = 556.0 * 559.2 - 130 * 105;
        assertEquals(130 * 105, ShippedScenes.area(scene, "light"), 1e-2);
        assertEquals(559.2 * 548.8, ShippedScenes.area(scene, "green"), 1);
        assertEquals(floor + back + ceiling, ShippedScenes.area(scene, "white"), 1);
    }

    @Test
    void light_givesWhatItsSpectrumSays() throws IOException {
        Scene scene = ShippedScenes.read(EMPTY);
        var light = scene.surfaces().stream().filter(surface -> surface.emits()).toList();
        assertEquals(1, light.size());
        assertEquals(17 * Math.PI, light.get(0).exitance().r(), 1e-4);
        assertEquals(11.8 * Math.PI, light.get(0).exitance().g(), 1e-4);
        assertEquals(4 * Math.PI, light.get(0).exitance().b(), 1e-4);
        assertEquals(.78, light.get(0).reflectance().r(), 1e-6);
    }

    @Test
    void walls_turnTheirFrontsInside() throws IOException {
        Scene scene = ShippedScenes.read(EMPTY);
        Vec3 middle = new Vec3(278, 274, -280);
        for (int t = 0; t < scene.triangles(); t++) {
            assertTrue(ShippedScenes.normal(scene, t).dot(middle.minus(scene.corner(t, 0))) > 200, scene.surface(t)
                    .name());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {FULL, EMPTY})
    void noTwoFaces_lieOnEachOther(String name) throws IOException {
        assertEquals(List.of(), new SceneFaces(ShippedScenes.read(name), 1e-3).coincidentFaces());
    }

    @ParameterizedTest
    @ValueSource(strings = {FULL, EMPTY})
    void onlyTheFront_isOpen(String name) throws IOException {
        assertEquals(4, new SceneFaces(ShippedScenes.read(name), 1e-3).openEdges().size());
    }
}
