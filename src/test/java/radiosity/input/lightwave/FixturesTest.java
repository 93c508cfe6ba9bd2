package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;
import radiosity.settings.ReadOptions.Emission;

/** One Cornell box nine ways. */
class FixturesTest {

    private static final String REFERENCE = "cornell-lwo2-lwsc3/cornell.lws";
    /** LWOB stores colours in bytes. */
    private static final double BYTE = 1 / 510.0;

    @ParameterizedTest
    @ValueSource(strings = {"cornell-lwo2-lwsc5/cornell.lws", "cornell-lwo3-lwsc3/cornell.lws",
        "cornell-lwo3-lwsc5/cornell.lws", "cornell-lwob-lwsc1/cornell.lws", "cornell-lwob-lwsc3/cornell.lws",
        "cornell-lwob-lwsc5/cornell.lws", "cornell-windows-paths/CORNELL.LWS"})
    void everyFixture_isTheSameRoom(String file) throws IOException {
        assertSameRoom(read(REFERENCE, Emission.LUMINOSITY), read(file, Emission.LUMINOSITY), 1);
    }

    @Test
    void paperSpecular_isTheRoomAtAFifteenthOfTheLamp() throws IOException {
        assertSameRoom(read(REFERENCE, Emission.LUMINOSITY), read("cornell-paper-specular/cornell.lws",
                Emission.SPECULAR), 1 / 15.0);
    }

    @Test
    void paperSpecular_withoutTheOption_isToldAbout() throws IOException {
        List<String> told = new ArrayList<>();
        Scene scene = LightWaveReader.read(Shared.path("lightwave/fixtures/cornell-paper-specular/cornell.lws"),
                ReadOptions.defaults(), told::add);
        assertTrue(scene.surfaces().stream().noneMatch(Surface::emits));
        assertTrue(told.stream().anyMatch(w -> w.contains("specular")), told.toString());
    }

    @Test
    void camera_looksIntoTheRoom() throws IOException {
        for (String file : List.of(REFERENCE, "cornell-lwob-lwsc1/cornell.lws")) {
            Camera camera = read(file, Emission.LUMINOSITY).camera().orElseThrow();
            assertEquals(new Vec3(2.78, 2.73, 8), camera.position());
            assertEquals(0, camera.forward().minus(new Vec3(0, 0, -1)).length(), 1e-12);
            assertEquals(0, camera.up().minus(new Vec3(0, 1, 0)).length(), 1e-12);
            assertEquals(Math.atan(1 / 2.8), camera.verticalHalfAngle(), 1e-12);
        }
        assertEquals(1, read(REFERENCE, Emission.LUMINOSITY).camera().orElseThrow().aspect(), 1e-12);
    }

    private static Scene read(String file, Emission emission) throws IOException {
        Path path = Shared.path("lightwave/fixtures/" + file);
        List<String> warnings = new ArrayList<>();
        Scene scene = LightWaveReader.read(path, ReadOptions.defaults().withEmission(emission), warnings::add);
        assertEquals(List.of(), warnings, file);
        return scene;
    }

    private static void assertSameRoom(Scene expected, Scene scene, double lamp) {
        assertEquals(36, expected.triangles());
        assertEquals(36, scene.triangles());
        for (int t = 0; t < 36; t++) {
            for (int k = 0; k < 3; k++) {
                assertEquals(0, expected.corner(t, k).minus(scene.corner(t, k)).length(), 1e-6, "triangle " + t);
            }
            assertClose(expected.surface(t).reflectance(), scene.surface(t).reflectance(), BYTE);
            assertClose(expected.surface(t).exitance().times(lamp), scene.surface(t).exitance(),
                    BYTE * Math.max(1, lamp * expected.surface(t).exitance().max()));
        }
        assertEquals(areas(expected).keySet(), areas(scene).keySet());
    }

    private static Map<String, Double> areas(Scene scene) {
        Map<String, Double> areas = new TreeMap<>();
        for (int t = 0; t < scene.triangles(); t++) {
            areas.merge(scene.surface(t).name(), scene.area(t), Double::sum);
        }
        return areas;
    }

    private static void assertClose(Rgb expected, Rgb got, double tolerance) {
        for (int c = 0; c < 3; c++) {
            assertEquals(expected.channel(c), got.channel(c), tolerance);
        }
    }
}
