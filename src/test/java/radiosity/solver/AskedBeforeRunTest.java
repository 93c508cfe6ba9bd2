package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.solver.SameBitsTest.SCENE;
import static radiosity.solver.SameBitsTest.settings;
import static radiosity.solver.SameBitsTest.shots;

import java.io.IOException;
import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import radiosity.settings.Schedule;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.testkit.ColouredRoom;

/** A calculation answers before it is run: nothing was shot, or what was shot before it was resumed. */
@Tag("slow")
class AskedBeforeRunTest {

    private static ProgressiveRadiosity calculation(Schedule schedule) {
        return new ProgressiveRadiosity(new LocalWorld(SCENE, settings(schedule), 2), shots(40));
    }

    @ParameterizedTest
    @EnumSource(Schedule.class)
    void beforeTheFirstRound_nothingIsShot(Schedule schedule) throws IOException {
        Solution atOnce = SameBitsTest.solve(new LocalWorld(SCENE, settings(schedule), 2), shots(40));
        ProgressiveRadiosity radiosity = calculation(schedule);
        SavedState state = radiosity.state();
        assertEquals(0, radiosity.solution().shots());
        assertEquals(0, radiosity.progress().shots());
        assertEquals(0, Arrays.stream(radiosity.ledger().shot()).sum());
        assertTrue(Arrays.stream(radiosity.ledger().emitted()).sum() > 0);
        assertTrue(radiosity.certificate(1).isEmpty());
        radiosity.run(progress -> true);
        ColouredRoom.assertSame(atOnce, radiosity.solution());

        ProgressiveRadiosity resumed = calculation(schedule);
        resumed.resume(state);
        resumed.run(progress -> true);
        ColouredRoom.assertSame(atOnce, resumed.solution());
    }

    @ParameterizedTest
    @EnumSource(Schedule.class)
    void resumed_answersAsBeforeTheStop(Schedule schedule) throws IOException {
        ProgressiveRadiosity stopped = calculation(schedule);
        stopped.run(progress -> progress.shots() < 5);
        Solution before = stopped.solution();
        ProgressiveRadiosity resumed = calculation(schedule);
        resumed.resume(before.state());
        assertEquals(before.state(), resumed.state());
        assertEquals(stopped.progress(), resumed.progress());
        assertEquals(stopped.certificate(1), resumed.certificate(1));
        ColouredRoom.assertSame(before, resumed.solution());
        assertFalse(resumed.progress().shots() == 0);
    }

    /** What was asked for before would be that of another state. */
    @Test
    void resumingACalculationThatWasAsked_isRefused() throws IOException {
        ProgressiveRadiosity radiosity = calculation(Schedule.PAPER);
        SavedState state = radiosity.state();
        assertEquals("resume: expected a calculation that nobody has run or asked yet",
                assertThrows(IllegalStateException.class, () -> radiosity.resume(state)).getMessage());
    }
}
