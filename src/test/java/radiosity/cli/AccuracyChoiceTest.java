package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.cli.render.AccuracyChoice;

/** What a time limit leads to, on a clock that is calculated: a solution takes fixed + varying / error^power in all. */
class AccuracyChoiceTest {

    private static final double PLENTY = 1e12;
    /** Part of the whole time that going on from a solution takes in any case, for shots and an estimate. */
    private static final double ROUND = .15;

    /** The accuracy that is done in time, or 0; in the end the time is over, or nothing finer is tried. */
    private static double reached(double fixed, double varying, double power, double limit, double memory) {
        AccuracyChoice choice = new AccuracyChoice(memory);
        double seconds = fixed;
        double before = 0;
        double reached = 0;
        for (double error = choice.next(limit); error > 0; error = choice.next(limit - seconds)) {
            double whole = fixed + varying * Math.pow(error, -power);
            seconds += whole - before + ROUND * whole;
            if (seconds > limit) {
                return reached;
            }
            before = whole;
            reached = error;
            choice.reached(error, seconds, (int) (100 * Math.pow(error, -1.5)));
        }
        return reached;
    }

    @ParameterizedTest
    @CsvSource({"2, .05, 1, 30", "2, .05, 1, 300", "2, .02, 1.3, 60", "2, .002, 1.6, 60", "20, .1, 1.3, 300",
        "1, .001, 2, 100", "10, 1, .8, 500"})
    void aQuarterOfTheTimeAtLeast_isWhatTheErrorReachedTakes(double fixed, double varying, double power, double limit) {
        double reached = reached(fixed, varying, power, limit, PLENTY);
        double seconds = fixed + varying * Math.pow(reached, -power);
        assertTrue(reached > 0 && seconds > limit / 4, "reached " + reached + " in " + seconds + " s");
    }

    @Test
    void shortOfTime_theCoarsestIsAll() {
        AccuracyChoice choice = new AccuracyChoice(PLENTY);
        assertEquals(AccuracyChoice.COARSEST, choice.next(-1));
        choice.reached(.18, 2, 1000);
        assertEquals(0, choice.next(-1));
        assertEquals(0, choice.next(0.3), "in so short a time nothing becomes better");
        double next = choice.next(2);
        assertTrue(next > .12 && next < .15, "in the same time again: " + next);
        assertEquals(.06, choice.next(1e6), 1e-12, "a third at most");
    }

    @Test
    void withoutEnd_itStopsNearTheFinest() {
        double reached = reached(1, 1e-6, 1, 1e9, PLENTY);
        assertTrue(reached >= AccuracyChoice.FINEST && reached < 1.1 * AccuracyChoice.FINEST, "got " + reached);
    }

    @Test
    void elementsFitTheMemory() {
        double reached = reached(1, 1e-6, 1, 1e9, 1e8);
        assertTrue(reached > 0 && 100 * Math.pow(reached, -1.5) * 1000 <= 1e8 * 1.01, "got " + reached);
    }
}
