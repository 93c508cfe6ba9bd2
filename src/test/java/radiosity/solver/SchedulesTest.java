package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.solver.SameBitsTest.SCENE;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import radiosity.settings.FormFactors;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Solution;
import radiosity.testkit.ColouredRoom;

/** The paper's ways to solve one linear system: they differ in how they come to its solution, not in that. */
class SchedulesTest {

    /** What is left unshot: with reflectance below .71, a third of it at most is still to come. */
    private static final double UNSENT = 1e-9;
    private static final Solution EXPECTED = solve(Schedule.PAPER, FormFactors.RAYCAST, UNSENT);

    private static Solution solve(Schedule schedule, FormFactors factors, double unsent) {
        RadiositySettings settings = new RadiositySettings(SCENE.area() / 120, 0, Double.POSITIVE_INFINITY, schedule)
                .factors(factors);
        try (LocalWorld world = new LocalWorld(SCENE, settings, 2)) {
            return SameBitsTest.solve(world, new StopRule(Integer.MAX_VALUE, unsent));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @EnumSource(value = Schedule.class, names = {"SHOOTING", "GATHERING", "MATRIX"})
    void converged_allSchedulesGiveOneSolution(Schedule schedule) {
        double[] found = solve(schedule, FormFactors.RAYCAST, UNSENT).irradiance();
        for (int i = 0; i < found.length; i++) {
            assertEquals(EXPECTED.irradiance()[i], found[i], 1e-7 * (1 + EXPECTED.irradiance()[i]));
        }
    }

    /** Section 2.2: "shooting and sorting is the best and gets the fastest convergence and gathering is the worst". */
    @Test
    void sorting_needsFewestShotsAndGatheringMost() {
        int sorted = solve(Schedule.PAPER, FormFactors.RAYCAST, 0.1).shots();
        int inTurn = solve(Schedule.SHOOTING, FormFactors.RAYCAST, 0.1).shots();
        int gathered = solve(Schedule.GATHERING, FormFactors.RAYCAST, 0.1).shots();
        assertTrue(sorted < inTurn && inTurn < gathered, sorted + ", " + inTurn + ", " + gathered);
    }

    /** The mean over the room: what is near to a wall errs most with the paper's rays, and weighs little. */
    @Tag("slow")
    @ParameterizedTest
    @EnumSource(FormFactors.class)
    void everyKindOfFormFactor_findsTheSameFlux(FormFactors factors) {
        double expected = EXPECTED.ledger().received()[0];
        double found = solve(Schedule.PAPER, factors, 1e-3).ledger().received()[0];
        assertEquals(expected, found, (factors == FormFactors.PLAIN ? 0.1 : 0.02) * expected);
    }

    @ParameterizedTest
    @EnumSource(FormFactors.class)
    void everyKindOfFormFactor_givesTheSameBitsHoweverDealt(FormFactors factors) throws IOException {
        RadiositySettings settings = SameBitsTest.settings(Schedule.PAPER).factors(factors);
        StopRule stop = SameBitsTest.shots(30);
        Solution local = SameBitsTest.solve(new LocalWorld(SCENE, settings, 1), stop);
        ColouredRoom.assertSame(local, SameBitsTest.solve(new LocalWorld(SCENE, settings, 2, 3), stop));
    }
}
