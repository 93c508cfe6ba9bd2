package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.scene.Camera;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;
import radiosity.settings.ReadOptions.Lights;

/** Lights and cameras as scenes describe them. */
class LightsTest {

    private static final String V1 = "LWSC\n1\nLoadObject room.lwo\n";
    private static final String V5 = "LWSC\n5\nLoadObjectLayer 1 10000000 room.lwo\n";

    @TempDir
    Path folder;

    private final List<String> told = new ArrayList<>();

    private Light light(String text) throws IOException {
        return Scenes.read(folder, text, ReadOptions.defaults(), told).lights().get(0);
    }

    private static void assertClose(Vec3 expected, Vec3 got) {
        assertEquals(0, expected.minus(got).length(), 1e-12, got.toString());
    }

    private static void assertClose(Rgb expected, Rgb got) {
        for (int c = 0; c < 3; c++) {
            assertEquals(expected.channel(c), got.channel(c), 1e-12);
        }
    }

    @Test
    void pointLight_hasItsIrradianceAtItsRange() throws IOException {
        Light light = light(V1 + "AddLight\nLightName Bulb\n" + motion("LightMotion", 1, 2, 3, 0, 0, 0)
                + "LightColor 255 0 51\nLgtIntensity 0.5\nLightType 1\nLightFalloff 2\nLightRange 4\n");
        assertEquals("Bulb", light.name());
        assertEquals(Light.Kind.POINT, light.kind());
        assertClose(new Rgb(0.5, 0, 0.1), light.power());
        assertClose(new Vec3(1, 2, -3), light.position());
        assertEquals(4, light.range());
    }

    @Test
    void pointLight_withoutRange_hasItAtOneUnit() throws IOException {
        assertEquals(1, light(V1 + "AddLight\nLightType 1\nLgtIntensity 2\n").range());
    }

    @Test
    void distantLight_shinesAlongItsAxis() throws IOException {
        Light light = light(V5 + "AddLight 20000000\n"
                + Scenes.motion3("LightMotion", 0, 9, 0, 0, Math.PI / 2, 0, 1, 1, 1)
                + "LightColor 1 0.5 0\nLightIntensity 3\nLightType 0\n");
        assertEquals(Light.Kind.DISTANT, light.kind());
        assertClose(new Rgb(3, 1.5, 0), light.power());
        assertClose(new Vec3(0, -1, 0), light.direction());
    }

    @Test
    void spotLight_hasHalfAngleAndSoftEdge() throws IOException {
        Light old = light(V1 + "AddLight\nLightType 2\nConeAngle 40\nEdgeAngle 10\n");
        assertEquals(Light.Kind.SPOT, old.kind());
        assertEquals(Math.toRadians(40), old.cone(), 1e-12);
        assertEquals(Math.toRadians(10), old.edge(), 1e-12);
        assertClose(new Vec3(0, 0, -1), old.direction());
    }

    /** Radians from version 3 on, but no angle from a light's axis is 30 radians. */
    @ParameterizedTest
    @CsvSource({"0.5, 0.5", "3.1, 3.1", "30, 0.5235987755982988", "400, 3.141592653589793", "-1, 0"})
    void coneOfVersion5_isInRadians_unlessItCannotBe(double written, double expected) throws IOException {
        assertEquals(expected, light(V5 + "AddLight 20000000\nLightType 2\nLightConeAngle " + written + "\n").cone(),
                1e-12);
    }

    @ParameterizedTest
    @CsvSource({"AreaLight, AREA", "PointLight, POINT", "Spotlight, SPOT", "DistantLight, DISTANT",
            "LinearLight, POINT"})
    void plugInOfVersion5_saysWhatALightIs(String plugin, Light.Kind kind) throws IOException {
        assertEquals(kind, light(V5 + "AddLight 20000000\nLightType 1\nPlugin LightHandler 1 " + plugin
                + "\nEndPlugin\n").kind());
    }

    @Test
    void areaLight_isASquareOfItsScale() throws IOException {
        Light light = light(V5 + "AddLight 20000000\n" + Scenes.motion3("LightMotion", 0, 5, 0, 0, Math.PI / 2, 0, 1.3,
                1.05, 1) + "LightColor 1 1 1\nLightIntensity 2\nLightType 4\n");
        assertClose(Rgb.grey(2 * Math.PI), light.power());
        assertClose(new Vec3(0.65, 0, 0), light.right());
        assertClose(new Vec3(0, 0, -0.525), light.up());
        assertClose(new Vec3(0, -1, 0), light.direction());
    }

    @Test
    void intensityEnvelope_isTakenAtTheFrame() throws IOException {
        String text = V1 + "AddLight\nLightType 1\nLgtIntensity (envelope)\n 1\n 2\n 0\n 0 1 0 0 0\n 4\n 40 1 0 0 0\n"
                + "EndBehavior 1\n";
        Scene scene = Scenes.read(folder, text, ReadOptions.defaults().withFrame(10), told);
        assertClose(Rgb.grey(1), scene.lights().get(0).power());
        assertEquals(0, Scenes.read(folder, text, ReadOptions.defaults(), told).lights().size());
    }

    @Test
    void targetedLightAndCamera_lookAtIt() throws IOException {
        String text = V1 + Scenes.motion1(3, 0, 4, 0, 0, 0, 1, 1, 1) + "AddLight\n"
                + motion("LightMotion", 3, 5, 4, 70, 0, 0) + "LightType 2\nTargetObject 1\n"
                + motion("CameraMotion", 0, 0, 0, 10, 20, 0) + "TargetObject 1\nZoomFactor 2\nCustomSize 200 100\n";
        Scene scene = Scenes.read(folder, text, ReadOptions.defaults(), told);
        assertClose(new Vec3(0, -1, 0), scene.lights().get(0).direction());
        Camera camera = scene.camera().orElseThrow();
        assertClose(new Vec3(0.6, 0, -0.8), camera.forward());
        assertClose(new Vec3(0, 1, 0), camera.up());
        assertEquals(Math.atan(0.5), camera.verticalHalfAngle(), 1e-12);
        assertEquals(2, camera.aspect(), 1e-12);
    }

    @Test
    void targetInTheSpaceOfATurnedParent_isLookedAt() throws IOException {
        String text = V1 + Scenes.motion1(3, 1, 4, 0, 0, 0, 1, 1, 1) + "AddNullObject n\n"
                + Scenes.motion1(0, 1, 0, 30, 40, 50, 2, 2, 2) + motion("CameraMotion", 1, 2, 3, 10, 20, 0)
                + "ParentObject 2\nTargetObject 1\n";
        Camera camera = Scenes.read(folder, text, ReadOptions.defaults(), told).camera().orElseThrow();
        assertClose(new Vec3(3, 1, -4).minus(camera.position()).unit(), camera.forward());
    }

    @Test
    void currentCamera_isTaken() throws IOException {
        String text = V5 + "AddCamera 30000000\n" + Scenes.motion3("CameraMotion", 1) + "AddCamera 30000001\n"
                + Scenes.motion3("CameraMotion", 2) + "CurrentCamera 1\n";
        assertEquals(2, Scenes.read(folder, text, ReadOptions.defaults(), told).camera().orElseThrow().position()
                .x());
    }

    @Test
    void lights_areTakenAsTheOptionSays() throws IOException {
        Files.write(folder.resolve("lamp.lwo"), Objects.lwo2(Objects.lwo2Surface("white", "",
                Objects.share("LUMI", 1), Objects.share("DIFF", .5))));
        String lit = "LWSC\n1\nLoadObject lamp.lwo\nAddLight\nLightType 1\n";
        String unlit = V1 + "AddLight\nLightType 1\n";
        assertEquals(List.of(0, 1), counts(Lights.AUTO, lit, unlit));
        assertEquals(List.of(0, 0), counts(Lights.IGNORE, lit, unlit));
        assertEquals(List.of(1, 1), counts(Lights.EMITTERS, lit, unlit));
        assertTrue(told.stream().anyMatch(t -> t.contains("lights are not used")), told.toString());
    }

    private List<Integer> counts(Lights lights, String... scenes) throws IOException {
        List<Integer> counts = new ArrayList<>();
        for (String scene : scenes) {
            ReadOptions options = ReadOptions.defaults().withLights(lights).withStrict(true);
            counts.add(Scenes.read(folder, scene, options, told).lights().size());
        }
        return counts;
    }

    private static String motion(String keyword, double x, double y, double z, double h, double p, double b) {
        return Scenes.motion1(x, y, z, h, p, b, 1, 1, 1).replace("ObjectMotion", keyword);
    }
}
