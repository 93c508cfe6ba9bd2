package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.cli.options.ExitCode;
import radiosity.cli.options.Failure;
import radiosity.cli.render.SceneChecks;
import radiosity.input.photometry.Photometry;
import radiosity.scene.Affine;
import radiosity.scene.Camera;
import radiosity.scene.Hierarchy;
import radiosity.scene.Lamp;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneNode;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/** A triangle of area 1/2 that emits: how many elements it would have is known before any work. */
class SceneChecksTest {

    private static final long PLENTY = 1L << 40;

    private final List<String> warnings = new ArrayList<>();

    private SceneChecks checks(boolean twoSided) {
        return checks(1, twoSided);
    }

    private SceneChecks checks(double exitance, boolean twoSided) {
        return new SceneChecks(triangle(exitance, twoSided, List.of()), warnings::add);
    }

    private static Scene triangle(double exitance, boolean twoSided, List<Light> lights) {
        Surface surface = new Surface("lamp", Rgb.grey(exitance), Rgb.grey(.5), twoSided);
        return new Scene("lamp.lws", new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2}, new int[] {0},
                List.of(surface), lights, Optional.empty());
    }

    @Test
    void moreThanTenMillionElements_areWarnedOf() {
        checks(false).elements(0.5 / 11e6, PLENTY);
        assertEquals(List.of("-pa: expected a patch area that gives at most 10,000,000 elements, got 11,000,000 or more"),
                warnings);
    }

    @Test
    void lampsWhoseLightArrivesNowhere_areNamed() {
        checks(1, false).unseen(List.of());
        assertEquals(List.of(), warnings);
        checks(1, false).unseen(List.of(new Lamp("strip", true, 0)));
        assertEquals("lamp.lws: expected lamps whose light arrives somewhere, got one enclosed, outside of the room, or"
                + " on the wrong side of all that is visible: strip", warnings.get(0));
    }

    @Test
    void bothSidesOfATriangle_count() {
        checks(false).elements(0.5 / 6e6, PLENTY);
        assertEquals(List.of(), warnings);
        checks(true).elements(0.5 / 6e6, PLENTY);
        assertEquals(1, warnings.size());
    }

    @Test
    void elementsThatCannotFit_areRefusedWithTheirNumber() {
        Failure failure = assertThrows(Failure.class, () -> checks(false).elements(0.5 / 1e9, 1 << 30));
        assertTrue(failure.getMessage().contains("1,000,000,000"), failure.getMessage());
        assertEquals(ExitCode.COMMAND_LINE, failure.exitCode());
    }

    /** 256 coloured lamps, each with its own light: an array holds that of 2.8 million vertices. */
    @Test
    void lightThatNoArrayHolds_isRefused() {
        SceneChecks.sizes(5.5e6, 768, 0);
        Failure failure = assertThrows(Failure.class, () -> SceneChecks.sizes(5.6e6, 768, 0));
        assertEquals("-pa: expected at most 5,592,405 patches in 768 channels, whose light fits an array, got 5,600,000;"
                + " give a larger -pa", failure.getMessage());
        SceneChecks.sizes(1.07e8, 3, 0);
    }

    @Test
    void meshesThatNoSceneFileHolds_areRefused() {
        SceneChecks.sizes(2.7e6, 768, 256);
        Failure failure = assertThrows(Failure.class, () -> SceneChecks.sizes(2.8e6, 768, 256));
        assertEquals("-pa: expected patches whose scene file is at most 4,294,967,295 bytes, the limit of glTF, got"
                + " 2,800,000 patches, which need 4,412,800,000 bytes or more; give a larger -pa",
                        failure.getMessage());
        assertThrows(Failure.class, () -> SceneChecks.sizes(1.08e8, 3, 0));
    }

    @Test
    void pictureByAVeryNarrowCamera_isRefusedBeforeAnyWork() {
        Camera camera = new Camera(Vec3.ZERO, new Vec3(0, 0, -1), new Vec3(0, 1, 0), .5, 1 / 1500.0);
        SceneChecks checks = new SceneChecks(new Scene("lamp.lws", new double[9], new int[3], new int[1],
                List.of(new Surface("s", Rgb.BLACK, Rgb.BLACK, false)), List.of(), Optional.of(camera)), warnings::add);
        checks.pictures(10);
        assertEquals("--size: expected pictures of at most 16384 pixels along an edge, got 800x1200000 by the camera of"
                + " lamp.lws; give a size", assertThrows(Failure.class, () -> checks.pictures(800)).getMessage());
    }

    @Test
    void chosenPatchArea_isNotDoubted() {
        checks(false).elements(0, 1);
        assertEquals(List.of(), warnings);
    }

    @Test
    void textureThatIsTooLarge_isRefusedBeforeAnyWork() {
        checks(false).textures("-ut", 8000);
        Failure failure = assertThrows(Failure.class, () -> checks(false).textures("-ut", 9000));
        assertEquals("-ut: expected at most 8192 samples per unit for lamp, whose texture may have 8192 texels, got 9000.0",
                failure.getMessage());
    }

    @Test
    void lampThatOverflowsFloats_isRefusedBeforeAnyWork() {
        checks(1e34, false).emission();
        Failure failure = assertThrows(Failure.class, () -> checks(1e35, false).emission());
        assertEquals("lamp.lws: expected surfaces that emit at most 1.701e+34 W/m2, got 1.000e+35 of lamp",
                failure.getMessage());
        assertEquals(ExitCode.FILE, failure.exitCode());
    }

    @ParameterizedTest
    @CsvSource({"10000, 0", "10001, 1"})
    void objectsThatTheSceneFileDoesNotKeep_areWarnedOf(int objects, int count) {
        SceneNode node = new SceneNode("chair", -1, "chair.lwo", Affine.IDENTITY);
        Scene scene = new Scene("hall.lws", new double[9], new int[3], new int[1],
                List.of(new Surface("s", Rgb.BLACK, Rgb.BLACK, false)), List.of(), Optional.empty(), new float[0],
                new float[0], new Hierarchy(Collections.nCopies(objects, node), new int[1]));
        new SceneChecks(scene, warnings::add).objects();
        assertEquals(Collections.nCopies(count, "hall.lws: expected at most 10,000 objects, whose names and hierarchy"
                + " the scene file keeps, got 10,001: it will have surfaces only"), warnings);
    }

    /** The triangle lies in the plane z = 0; its corners are from 0 to 1. */
    @ParameterizedTest
    @CsvSource({"0.2, 0.2, 3, 0, 0, -1, 0", "0.2, 0.2, 3, 0, 0, 1, 1", "0.2, 5, 3, 0, 0, -1, 1",
        "0.2, 5, 0, 0, -1, 0, 0", "200, 200, 3000, 0, 0, -1, 1", "0.5, 0.5, 0, 0, 0, 1, 0", "1.1, 1.1, 0.1, 0, 1, 0, 0",
        "3, 3, 3, -1, -1, -1, 0", "3, 3, 3, -1, 1, -1, 1"})
    void luminaireThatIsElsewhere_isWarnedOf(double x, double y, double z, double dx, double dy, double dz, int count)
            throws IOException {
        String file = "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 30\n0 90\n0\n100 100\n";
        Light lamp = Photometry.of(file.getBytes(StandardCharsets.US_ASCII), "a.ies").at("Lamp", new Vec3(x, y, z),
                new Vec3(dx, dy, dz), Vec3.ZERO, Rgb.grey(1), 1);
        new SceneChecks(triangle(1, false, List.of(lamp)), warnings::add).luminaires();
        assertEquals(count, warnings.size(), warnings.toString());
        if (x == 200) {
            assertEquals("lamp.lws: expected luminaires in the scene or aimed at it, got Lamp at 200.000,200.000,3000.00,"
                    + " outside of 0.00000,0.00000,0.00000 to 1.00000,1.00000,0.00000; check unit and axes",
                    warnings.get(0));
        }
    }

    @Test
    void sceneWithALamp_isNotWarnedOf() {
        checks(false).light();
        assertEquals(List.of(), warnings);
    }
}
