package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.cli.terminal.ProgressBarDisplay;
import radiosity.cli.terminal.ProgressText;
import radiosity.cli.terminal.StopRuleCourse;
import radiosity.settings.StopRule;
import radiosity.solution.Progress;

/** What a user sees while a render goes on. */
class ProgressTextTest {

    private static final long SECOND = 1_000_000_000L;
    private static final Pattern SHARE = Pattern.compile("(\\d+) %(,|$)");

    private final AtomicLong clock = new AtomicLong();
    private final ProgressText text = new ProgressText(new StopRuleCourse(new StopRule(Integer.MAX_VALUE, 0.001), Double.NaN,
            clock::get));

    private static Progress progress(int shots, double unsent, boolean gathers) {
        return new Progress(shots, 1, unsent, 1_234_567, gathers);
    }

    private int share() {
        Matcher share = SHARE.matcher(text.bar(60));
        assertTrue(share.find(), text.bar(60));
        return Integer.parseInt(share.group(1));
    }

    @Test
    void phase_isNamed() {
        text.phase("reading room.glb");
        assertTrue(text.bar(60).startsWith("reading room.glb [ "), text.bar(60));
        text.show(progress(0, 1, false));
        assertTrue(text.bar(60).startsWith("preparing [ "), text.bar(60));
        text.show(progress(1, .9, false));
        assertTrue(text.bar(60).startsWith("distributing light ["), text.bar(60));
        text.show(progress(2, .9, true));
        assertTrue(text.bar(60).startsWith("refining the mesh ["), text.bar(60));
    }

    @Test
    void narrowTerminal_keepsTheShare() {
        text.show(progress(1, .9, false));
        assertEquals("distribu 0 %", text.bar(12));
    }

    @Test
    void share_neverGoesBack() {
        int before = 0;
        for (double unsent : new double[] {1, .5, .01, .7, 1.2, .005, .3, .001}) {
            text.show(progress(3, unsent, false));
            assertTrue(share() >= before, "after " + before + " %: " + text.bar(60));
            before = share();
        }
        assertEquals(95, before);
    }

    @Test
    void timeLeft_isShownAfterFiveSeconds() {
        text.show(progress(1, 1, false));
        clock.set(4 * SECOND);
        text.show(progress(2, .1, false));
        assertFalse(text.bar(60).contains("left"), text.bar(60));
        clock.set(6 * SECOND);
        text.show(progress(3, .1, false));
        assertTrue(text.bar(60).endsWith("31 %, 13 s left"), text.bar(60));
    }

    @ParameterizedTest
    @ValueSource(ints = {60, 61, 79, 80, 100, 132, 300})
    void line_fitsTheTerminal_andHasPhaseShareAndTime(int width) {
        text.show(progress(1, 1, false));
        clock.set(10_000 * SECOND);
        text.show(progress(1_234_567, .9, true));
        String line = text.bar(width);
        assertTrue(line.length() <= width, line.length() + ": " + line);
        assertTrue(line.matches("refining the mesh \\[#* *] \\d+ %, \\d+ h \\d+ min left.*"), line);
        assertEquals(width > 132, line.contains("1,234,567 shots, 90 % not yet distributed, 1,234,567 mesh elements"));
    }

    @Test
    void shorterLine_leavesNothingOfALongerOne() {
        ByteArrayOutputStream shown = new ByteArrayOutputStream();
        ProgressBarDisplay bar = new ProgressBarDisplay(new PrintStream(shown, true, StandardCharsets.UTF_8), () -> 60,
                text, clock::get);
        bar.phase("reading a scene of a long name");
        bar.phase("short");
        bar.message("a warning");
        bar.close();
        for (String line : shown.toString(StandardCharsets.UTF_8).split("[\r\n]+")) {
            assertTrue(line.length() < 60, line);
        }
        assertTrue(shown.toString(StandardCharsets.UTF_8).contains("\ra warning" + System.lineSeparator()));
        assertTrue(shown.toString(StandardCharsets.UTF_8).endsWith(" ".repeat(49) + "\r"), "nothing is left");
    }
}
