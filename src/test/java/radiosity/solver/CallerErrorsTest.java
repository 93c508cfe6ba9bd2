package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static radiosity.solver.SameBitsTest.SCENE;

import java.io.IOException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.master.RemoteWorld;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.testkit.TestLink;

/** Numbers that make no sense are refused with one line, before anything is calculated. */
class CallerErrorsTest {

    private static final RadiositySettings SETTINGS = SameBitsTest.settings(Schedule.PAPER);

    @ParameterizedTest
    @ValueSource(ints = {0, -1, Integer.MIN_VALUE})
    void pauseWithoutShots_isRefused(int shots) {
        ProgressiveRadiosity radiosity = new ProgressiveRadiosity(new LocalWorld(SCENE, SETTINGS, 1),
                SameBitsTest.shots(3));
        assertEquals("pause: expected a number of shots of at least 1, got " + shots,
                assertThrows(IllegalArgumentException.class, () -> radiosity.pauseEvery(shots)).getMessage());
    }

    @ParameterizedTest
    @ValueSource(ints = {0, -1, Integer.MIN_VALUE})
    void worldWithoutThreads_isRefused(int threads) throws IOException {
        String expected = "threads: expected at least 1, got " + threads;
        assertEquals(expected, assertThrows(IllegalArgumentException.class,
                () -> new LocalWorld(SCENE, SETTINGS, threads)).getMessage());
        assertEquals(expected,
                assertThrows(IllegalArgumentException.class, () -> new RemoteWorld(SCENE, SETTINGS, threads,
                line -> { }, TestLink.sound(1, 1), System::nanoTime)).getMessage());
        ProgressiveRadiosity radiosity = new ProgressiveRadiosity(new LocalWorld(SCENE, SETTINGS, 1),
                SameBitsTest.shots(3));
        radiosity.run(progress -> true);
        assertEquals(expected, assertThrows(IllegalArgumentException.class, () -> radiosity.certificate(threads))
                .getMessage());
    }
}
