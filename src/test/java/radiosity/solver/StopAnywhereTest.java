package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.solver.SameBitsTest.SCENE;
import static radiosity.solver.SameBitsTest.settings;
import static radiosity.solver.SameBitsTest.shots;

import java.io.IOException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.EnergyLedger;
import radiosity.solution.Solution;
import radiosity.testkit.ColouredRoom;

/** Stopped wherever the listener is asked, a calculation can be looked at, and goes on to the same bits. */
@Tag("slow")
class StopAnywhereTest {

    @ParameterizedTest
    @EnumSource(Schedule.class)
    void stoppedAnywhere_goesOnToTheSameBits(Schedule schedule) throws IOException {
        Solution atOnce = SameBitsTest.solve(new LocalWorld(SCENE, settings(schedule), 2), shots(100));
        for (int asked = 1; asked < 40; asked += 1 + asked / 6) {
            Solution stopped = stopped(schedule, asked);
            ProgressiveRadiosity rest = new ProgressiveRadiosity(new LocalWorld(SCENE, settings(schedule), 2),
                    shots(100));
            rest.resume(stopped.state());
            rest.run(progress -> true);
            ColouredRoom.assertSame(atOnce, rest.solution());
        }
    }

    /**
     * The mesh is fine enough at once; whoever goes on has to ask for the coarse system's rows before the last shots.
     */
    @Test
    void stoppedWhereNothingIsSplitLater_goesOnToTheSameBits() throws IOException {
        RadiositySettings coarse = new RadiositySettings(SCENE.area() / 120, 1, Double.POSITIVE_INFINITY,
                Schedule.PREDICT, 1, 1000);
        StopRule stop = new StopRule(Integer.MAX_VALUE, 0.05);
        Solution atOnce = SameBitsTest.solve(new LocalWorld(SCENE, coarse, 2), stop);
        Solution first = SameBitsTest.solve(new LocalWorld(SCENE, coarse, 2), shots(3));
        assertEquals(first.elements(), atOnce.elements());
        ProgressiveRadiosity rest = new ProgressiveRadiosity(new LocalWorld(SCENE, coarse, 2), stop);
        rest.resume(first.state());
        rest.run(progress -> true);
        assertEquals(atOnce.rounds(), rest.solution().rounds());
        ColouredRoom.assertSame(atOnce, rest.solution());
    }

    private static Solution stopped(Schedule schedule, int asked) throws IOException {
        ProgressiveRadiosity radiosity = new ProgressiveRadiosity(new LocalWorld(SCENE, settings(schedule), 2),
                shots(100));
        int[] left = {asked};
        radiosity.run(progress -> --left[0] > 0);
        assertTrue(left[0] >= 0, "asked once more after a no");
        return radiosity.solution();
    }

    @Test
    void prediction_isAskedWhileItsRowsAreMade() throws IOException {
        ProgressiveRadiosity radiosity = new ProgressiveRadiosity(new LocalWorld(SCENE, settings(Schedule.PREDICT), 2),
                shots(100),
                Double.MIN_VALUE);
        int[] left = {2};
        radiosity.run(progress -> --left[0] > 0);
        assertEquals(0, radiosity.solution().shots());
        assertEquals(0, stopped(Schedule.PREDICT, 1).shots());
    }

    /** What was shot before has not reached them: their light and the ledger are those of before they were made. */
    @Test
    void stoppedWhileNewElementsGather_figuresAreThoseOfBefore() throws IOException {
        ProgressiveRadiosity radiosity = new ProgressiveRadiosity(
                new LocalWorld(SCENE, settings(Schedule.PREDICT), 2), new StopRule(Integer.MAX_VALUE, 1e-3));
        EnergyLedger[] before = new EnergyLedger[1];
        double[] unsent = new double[1];
        radiosity.run(progress -> {
            if (!progress.gathers()) {
                before[0] = radiosity.ledger();
                unsent[0] = progress.unsent();
            }
            return !progress.gathers();
        });
        assertTrue(radiosity.progress().gathers());
        assertEquals(unsent[0], radiosity.progress().unsent());
        EnergyLedger ledger = radiosity.solution().ledger();
        assertArrayEquals(before[0].unshot(), ledger.unshot());
        assertArrayEquals(before[0].received(), ledger.received());
        assertTrue(radiosity.certificate(1).isEmpty());
    }
}
