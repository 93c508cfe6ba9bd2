package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.cli.render.AccuracyChoice;

/** What a time limit leads to, on a clock that is calculated: an estimate comes after fixed + varying / accuracy^power. */
class AccuracyChoiceTest {

    private static final double PLENTY = 1e12;

    /** The accuracy that is done in time, or 0; in the end the time is over, or nothing finer is tried. */
    private static double reached(double fixed, double varying, double power, double limit, double memory) {
        AccuracyChoice choice = new AccuracyChoice(memory);
        double left = limit;
        double reached = 0;
        for (double accuracy = choice.next(left); accuracy > 0; accuracy = choice.next(left)) {
            double seconds = fixed + varying * Math.pow(accuracy, -power);
            left -= seconds;
            if (left < 0) {
                return reached;
            }
            reached = accuracy;
            choice.took(accuracy, seconds, (int) (100 * Math.pow(accuracy, -1.5)));
        }
        return reached;
    }

    @ParameterizedTest
    @CsvSource({"2, .05, 1, 30", "2, .05, 1, 300", "2, .02, 1.3, 60", "2, .002, 1.6, 60", "20, .1, 1.3, 300",
        "1, .001, 2, 100", "10, 1, .8, 500"})
    void aQuarterOfTheTimeAtLeast_goesIntoWhatCounts(double fixed, double varying, double power, double limit) {
        double reached = reached(fixed, varying, power, limit, PLENTY);
        double seconds = fixed + varying * Math.pow(reached, -power);
        assertTrue(reached > 0 && seconds > limit / 4, "reached " + reached + " in " + seconds + " s");
    }

    @Test
    void shortOfTime_theCoarsestIsAll() {
        AccuracyChoice choice = new AccuracyChoice(PLENTY);
        assertEquals(AccuracyChoice.COARSEST, choice.next(-1));
        choice.took(AccuracyChoice.COARSEST, 2, 1000);
        assertEquals(0, choice.next(-1));
        assertEquals(0, choice.next(0.2));
        assertEquals(AccuracyChoice.COARSEST / 1.25, choice.next(0.5), 1e-12, "a little finer, as nothing is lost");
    }

    @Test
    void withoutEnd_itStopsAtTheFinest() {
        assertEquals(AccuracyChoice.FINEST, reached(1, 1e-6, 1, 1e9, PLENTY), 1e-9);
    }

    @Test
    void elementsFitTheMemory() {
        double reached = reached(1, 1e-6, 1, 1e9, 1e8);
        assertTrue(reached > 0 && 100 * Math.pow(reached, -1.5) * 1000 <= 1e8 * 1.01, "got " + reached);
    }
}
