package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;

/** A triangle of area 1/2 that emits: how many elements it would have is known before any work. */
class SceneChecksTest {

    private static final long PLENTY = 1L << 40;

    private final List<String> warnings = new ArrayList<>();

    private SceneChecks checks(boolean twoSided) {
        return checks(1, twoSided);
    }

    private SceneChecks checks(double exitance, boolean twoSided) {
        Surface surface = new Surface("lamp", Rgb.grey(exitance), Rgb.grey(.5), twoSided);
        return new SceneChecks(new Scene("lamp.lws", new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2},
                new int[] {0}, List.of(surface), List.of(), Optional.empty()), warnings::add);
    }

    @Test
    void moreThanTenMillionElements_areWarnedOf() {
        checks(false).elements(0.5 / 11e6, PLENTY);
        assertEquals(List.of("-pa: expected a patch area that gives at most 10,000,000 elements, got 11,000,000 or more"),
                warnings);
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

    @Test
    void chosenPatchArea_isNotDoubted() {
        checks(false).elements(0, 1);
        assertEquals(List.of(), warnings);
    }

    @Test
    void textureThatIsTooLarge_isRefusedBeforeAnyWork() {
        checks(false).textures(8000);
        Failure failure = assertThrows(Failure.class, () -> checks(false).textures(9000));
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

    @Test
    void sceneWithALamp_isNotWarnedOf() {
        checks(false).light();
        assertEquals(List.of(), warnings);
    }
}
