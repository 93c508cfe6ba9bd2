package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.settings.Accuracy;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.setup.InitialMesh;
import radiosity.solution.SavedState;
import radiosity.testkit.ColouredRoom;

/** A saved calculation goes on with its own settings only; a refusal names those that differ, and no others. */
class OtherSettingsTest {

    private static final Scene SCENE = ColouredRoom.SCENE;
    private static final RadiositySettings COARSE = new RadiositySettings(SCENE.area() / 60, 1,
            Double.POSITIVE_INFINITY,
            Schedule.PREDICT).accurate(0.5);

    private static ProgressiveRadiosity calculation(RadiositySettings settings) {
        return new ProgressiveRadiosity(new LocalWorld(SCENE, settings, 1), new StopRule(3, 1e-3));
    }

    private static SavedState state(RadiositySettings settings) throws IOException {
        ProgressiveRadiosity radiosity = calculation(settings);
        radiosity.run(progress -> true);
        return radiosity.state();
    }

    private static String refusal(RadiositySettings before, RadiositySettings now) throws IOException {
        SavedState state = state(before);
        return assertThrows(SceneFormatException.class, () -> calculation(now).resume(state)).getMessage();
    }

    @Test
    void otherAccuracy_isRefusedByName() throws IOException {
        String refusal = refusal(COARSE, COARSE.accurate(0.1));
        String accuracy = "--accuracy %s%% \\(first tolerance \\S+, first mesh error \\S+\\)";
        assertTrue(refusal.matches("the saved calculation: expected the same scene and settings \\("
                + accuracy.formatted("10\\.0000") + "\\), got " + accuracy.formatted("50\\.0000")),
                refusal);
    }

    /** A saved state is of one version of the program: others find other elements. */
    @Test
    void otherVersions_areRefusedAsSuch() {
        InitialMesh mesh = new InitialMesh(SCENE, COARSE);
        String older = mesh.fingerprint().replaceFirst("state \\d+", "state 3");
        assertEquals("the saved calculation: expected the same scene and settings, got one that another version of the"
                + " program has made", assertThrows(SceneFormatException.class,
                () -> mesh.checkFingerprint(older)).getMessage());
    }

    @Test
    void meshErrorAlone_isRefusedToo() throws IOException {
        RadiositySettings finer = new RadiositySettings(COARSE.patchArea(), COARSE.rays(), COARSE.meshing(),
                COARSE.schedule(), COARSE.tolerance(), COARSE.meshError() / 2);
        assertTrue(refusal(COARSE, finer).contains("first mesh error " + COARSE.meshError() / 2 + ")"));
    }

    @Test
    void otherSchedule_isNamed() throws IOException {
        RadiositySettings paper = new RadiositySettings(COARSE.patchArea(), 1, Double.POSITIVE_INFINITY,
                Schedule.PAPER);
        RadiositySettings meshed = new RadiositySettings(COARSE.patchArea(), 1, 5, Schedule.PAPER);
        assertEquals("the saved calculation: expected the same scene and settings (-mt 5.0), got -mt Infinity",
                refusal(paper, meshed));
    }

    /** The accuracy says nothing where nothing is predicted; the default one is the same by its name. */
    @Test
    void settingsThatAreTheSame_goOn() throws IOException {
        RadiositySettings standard = new RadiositySettings(COARSE.patchArea(), 1, Double.POSITIVE_INFINITY,
                Schedule.PREDICT);
        SavedState state = state(standard);
        assertDoesNotThrow(() -> calculation(standard.accurate(Accuracy.DEFAULT)).resume(state));
        RadiositySettings paper = new RadiositySettings(COARSE.patchArea(), 1, Double.POSITIVE_INFINITY,
                Schedule.PAPER);
        SavedState papers = state(paper);
        assertDoesNotThrow(() -> calculation(paper.accurate(0.1)).resume(papers));
    }

    @Test
    void calculationOfBefore_isRefusedForItsAccuracy() {
        InitialMesh mesh = new InitialMesh(SCENE, COARSE);
        String before = mesh.fingerprint().replaceAll(" --accuracy.*", "");
        String refusal = assertThrows(SceneFormatException.class, () -> mesh.checkFingerprint(before)).getMessage();
        assertTrue(refusal.endsWith("), got none"), refusal);
    }
}
