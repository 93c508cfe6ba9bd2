package radiosity.extremes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.settings.StopRule;
import radiosity.solution.Solution;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/** What is predicted in rooms that reflect all but a ten-thousandth grows by no differences between rounds. */
class WhiteRoomTest {

    /** Where rays of one round were others than those of the round before, every round left more than that. */
    @ParameterizedTest
    @ValueSource(doubles = {.2, .1, .05, .02})
    void fewRounds_distributeAllLight(double accuracy) {
        Solve most = new Solve(Solve.byDefault().accurate(accuracy).settings(),
                new StopRule(20_000, StopRule.DEFAULT_UNSENT), 1);
        Solution solution = most.solution(RoomScenes.withBlocks(RoomScenes.grey("wall", 0, .9999),
                RoomScenes.grey("lamp", 10, .9999)));
        assertTrue(solution.rounds() < 60, solution.rounds() + " rounds");
        double emitted = solution.ledger().emitted()[0];
        assertEquals(emitted, solution.ledger().absorbed()[0], .02 * emitted);
    }
}
