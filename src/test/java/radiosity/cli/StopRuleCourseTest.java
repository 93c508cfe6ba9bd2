package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import radiosity.cli.terminal.ProgressText;
import radiosity.cli.terminal.StopRuleCourse;
import radiosity.settings.StopRule;
import radiosity.solution.Progress;

/** What is foretold of the time that a render still takes. */
class StopRuleCourseTest {

    private static final long SECOND = 1_000_000_000L;

    private final AtomicLong clock = new AtomicLong();
    private final StopRuleCourse course = new StopRuleCourse(new StopRule(Integer.MAX_VALUE, 0.01), Double.NaN, clock::get);

    private static Progress unsent(double unsent) {
        return new Progress(1, 1, unsent, 1000, false);
    }

    @Test
    void aFirstShotThatChangesAlmostNothing_foretellsNothing() {
        course.done(unsent(1));
        clock.set(SECOND);
        assertEquals(0, course.left(unsent(1 - 1e-8)));
    }

    @Test
    void halfTheLight_takesAsLongAgain_andALittleForTheRest() {
        course.done(unsent(1));
        clock.set(10 * SECOND);
        assertEquals(10 * (1 / (.95 / 2) - 1), course.left(unsent(0.1)), 1e-3);
        assertTrue(course.left(unsent(0.5)) > 10);
    }

    @Test
    void nothingUnsent_isDone_alsoWhereNothingMayBeUnsent() {
        StopRuleCourse toTheEnd = new StopRuleCourse(new StopRule(Integer.MAX_VALUE, 0), Double.NaN, clock::get);
        assertEquals(0, toTheEnd.done(unsent(1)));
        assertEquals(0, toTheEnd.done(unsent(0.5)));
        assertEquals(.95, toTheEnd.done(unsent(0)));
    }

    @Test
    void errorThatIsTooLarge_showsWhatIsLeftToTheOneAskedFor() {
        StopRuleCourse toAnError = new StopRuleCourse(new StopRule(Integer.MAX_VALUE, 0.01), 0.02, clock::get);
        toAnError.done(unsent(1));
        clock.set(10 * SECOND);
        Progress looked = new Progress(1, 1, 0.001, 1000, 0.08, false);
        assertEquals(10 * (8 - 1), toAnError.left(looked), 1e-9);
        clock.set(20 * SECOND);
        assertEquals(60, toAnError.left(looked), 1e-9);
        ProgressText text = new ProgressText(toAnError);
        text.show(looked);
        assertEquals("distributing light, 25 %: 1 shot, 0.10 % not yet distributed, 1,000 mesh elements, +- 8.0 %,"
                + " 2.0 % in about 1 min 0 s", text.line());
    }
}
