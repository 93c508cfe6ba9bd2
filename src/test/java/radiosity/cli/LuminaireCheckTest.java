package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.cli.render.LuminaireCheck;
import radiosity.scene.Light;
import radiosity.scene.Luminaire;
import radiosity.scene.LuminousIntensity;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/** Luminaires outside a triangle that is seen from above, with corners at (0, 0, 0), (0, 0, 1) and (1, 0, 0). */
class LuminaireCheckTest {

    private static final double[] FLOOR = {0, 0, 0, 0, 0, 1, 1, 0, 0};

    private static List<String> warnings(Vec3 at, boolean twoSided, Vec3 down, double[] triangles) {
        LuminousIntensity below = new LuminousIntensity(LuminousIntensity.Type.C, new double[] {0, 360},
                new double[] {0, 80, 85, 180}, new double[] {100, 100, 0, 0, 100, 100, 0, 0});
        Light light = new Light("lamp", Light.Kind.POINT, Rgb.grey(100), at, down, Vec3.ZERO, Vec3.ZERO, 1, 0, 0,
                Optional.of(new Luminaire(below, new Vec3(0, 0, 1), 0, 0)));
        int[] corners = new int[triangles.length / 3];
        Arrays.setAll(corners, i -> i);
        List<String> warnings = new ArrayList<>();
        new LuminaireCheck(new Scene("a.lws", triangles, corners, new int[corners.length / 3],
                List.of(new Surface("s", Rgb.BLACK, Rgb.grey(.5), twoSided)), List.of(light), Optional.empty()),
                warnings::add).outside();
        return warnings;
    }

    @ParameterizedTest
    @CsvSource({"0.2, 1, 0.2, false, 0", "0.2, -1, 0.2, false, 1", "0.2, -1, 0.2, true, 1", "1000, 0.001, 0, true, 1",
        "0.2, 1e5, 0.2, false, 0"})
    void luminaireThatShinesDown_lightsWhatIsBelowItAndSeenFromAbove(double x, double y, double z, boolean twoSided,
            int count) {
        assertEquals(count, warnings(new Vec3(x, y, z), twoSided, new Vec3(0, -1, 0), FLOOR).size());
    }

    @Test
    void luminaireThatShinesUp_lightsATwoSidedSurfaceFromBelow() {
        Vec3 up = new Vec3(0, 1, 0);
        assertEquals(0, warnings(new Vec3(.2, -1, .2), true, up, FLOOR).size());
        assertEquals(1, warnings(new Vec3(.2, -1, .2), false, up, FLOOR).size());
    }

    /** Another triangle, seen from below, hides all of the floor from above. */
    @Test
    void lightThatIsStopped_meetsNoSurface() {
        double[] covered = {0, 0, 0, 0, 0, 1, 1, 0, 0, -9, .5, -9, 20, .5, -9, -9, .5, 20};
        assertEquals(List.of("a.lws: expected luminaires whose light meets a surface, got lamp, which is outside the scene"
                + " and whose light meets none"), warnings(new Vec3(.2, 1, .2), false, new Vec3(0, -1, 0), covered));
    }

    @Test
    void luminaireWithinTheScene_isNotDoubted() {
        assertEquals(0, warnings(new Vec3(.2, 0, .2), false, new Vec3(0, 1, 0), FLOOR).size());
    }
}
