package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.cli.options.ExitCode;
import radiosity.cli.render.SavedCalculation;
import radiosity.testkit.Program;
import radiosity.testkit.ProgramRun;

/** Ended from outside in mid-render, the program saves a scene file from which it can go on. */
@Tag("slow")
@Timeout(value = 2, unit = TimeUnit.MINUTES, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no signals and no pseudo terminals")
class StopTest {

    private static final String WORD = "distributing";
    private static final String LONG_RENDER = "--schedule paper -pa 300 foobar.lws foobar.scene";
    private static final String LONG_PICTURE = "-pa 5000 -it 2 --picture a.png --final-gather 30000 foobar.lws"
            + " foobar.scene";

    @TempDir
    Path directory;

    private Program program;

    @BeforeEach
    void makeDirectory() throws IOException {
        program = new Program(directory);
    }

    @ParameterizedTest
    @CsvSource({"TERM, 143, paper, 1", "INT, 130, paper, 1", "TERM, 143, predict, 0"})
    void signal_savesAndEndsWithItsCode(String signal, int expected, String schedule, int leastShots) throws Exception {
        Process render = program.start(RendererWithPatience.command(RendererWithPatience.ENDLESS,
                "--schedule " + schedule + " -pa 60 -se 0 foobar.lws foobar.scene"));
        Program.readUntil(render, WORD);
        new ProcessBuilder("kill", "-" + signal, Long.toString(render.pid())).start().waitFor();
        String rest = Program.rest(render);
        assertEquals(expected, render.waitFor(), rest);
        assertTrue(rest.contains("stopping after this round"), rest);
        goesOn(leastShots);
    }

    /** Baking such textures takes much longer than saving may. */
    @Test
    void signal_endsInTimeWhereSavingTakesLonger_andTheJournalOfTheLastRoundStands() throws Exception {
        String arguments = "-pa 5000 --schedule paper -it 40000 -se 0 -ut 3.8 foobar.lws foobar.scene";
        Process render = program.start(RendererWithPatience.command(3, arguments));
        Program.readUntil(render, WORD);
        new ProcessBuilder("kill", "-TERM", Long.toString(render.pid())).start().waitFor();
        String rest = Program.rest(render);
        assertEquals(143, render.waitFor(), rest);
        assertTrue(rest.endsWith("ending before everything is saved; the same command goes on from foobar.scene.journal"
                + System.lineSeparator()), rest);
        Process again = program.start(arguments);
        String begin = Program.readUntil(again, "cut off");
        Matcher kept = Pattern.compile("foobar.scene.journal: going on after (\\d+) shots? of a render that was cut off")
                .matcher(begin);
        assertTrue(kept.find(), begin);
        Matcher shown = Pattern.compile("(\\d+) shots?, ").matcher(rest);
        while (shown.find()) {
            assertTrue(Integer.parseInt(kept.group(1)) >= Integer.parseInt(shown.group(1)), begin + rest);
        }
        again.destroyForcibly().waitFor();
    }

    @Test
    void anyKey_savesAndEndsWell() throws Exception {
        Process render = program.start(onTerminal("x", WORD, Program.command(LONG_RENDER)));
        String shown = Program.rest(render);
        assertEquals(ExitCode.DONE, render.waitFor(), shown);
        assertTrue(shown.contains("distributing light [") && shown.contains("] 0 %"), shown);
        assertTrue(shown.contains("stopped: the same command with -tf foobar.scene goes on"), shown);
        goesOn(1);
    }

    /** The scene file is saved before pictures are drawn, and stays. */
    @Test
    void anyKey_leavesOutPicturesThatTakeLong() throws Exception {
        Process render = program.start(onTerminal("x", "drawing", Program.command(LONG_PICTURE)));
        String shown = Program.rest(render);
        assertEquals(ExitCode.DONE, render.waitFor(), shown);
        assertTrue(shown.contains("leaving out the pictures that are not finished"), shown);
        assertTrue(shown.contains("a.png: left out, as it was not wanted any more"), shown);
        assertTrue(!Files.exists(program.file("a.png")));
        goesOn(1);
    }

    @Test
    void signal_leavesOutPicturesThatTakeLong() throws Exception {
        Process render = program.start(LONG_PICTURE);
        Program.readUntil(render, "drawing");
        new ProcessBuilder("kill", "-TERM", Long.toString(render.pid())).start().waitFor();
        String rest = Program.rest(render);
        assertEquals(143, render.waitFor(), rest);
        assertTrue(rest.contains("a.png: left out"), rest);
        assertTrue(!Files.exists(program.file("a.png")));
        goesOn(1);
    }

    @Test
    void controlC_onATerminalIsASignal() throws Exception {
        Process render = program.start(onTerminal("\u0003", WORD,
                RendererWithPatience.command(RendererWithPatience.ENDLESS, LONG_RENDER)));
        String shown = Program.rest(render);
        assertEquals(130, render.waitFor(), shown);
        goesOn(1);
    }

    @Test
    void inputThatIsNoTerminal_isNotRead() throws Exception {
        Process render = program.start("-pa 5000 -it 30 foobar.lws foobar.scene");
        render.getOutputStream().write("keys\n".getBytes());
        render.getOutputStream().close();
        String shown = Program.rest(render);
        assertEquals(ExitCode.DONE, render.waitFor(), shown);
        assertEquals(30, SavedCalculation.read(program.file("foobar.scene")).shots());
    }

    @Test
    void fullDisk_keepsTheOldFileAndIsToldInOneLine() throws Exception {
        Path output = Files.writeString(program.file("foobar.scene"), "the old file");
        List<String> command = new ArrayList<>(List.of("sh", "-c", "ulimit -f 80; exec \"$@\"", "sh"));
        command.addAll(Program.command("-q -pa 2000 -it 20 foobar.lws foobar.scene"));
        Process render = program.start(command);
        String printed = Program.rest(render);
        assertEquals(ExitCode.FILE, render.waitFor(), printed);
        List<String> lines = new ArrayList<>(printed.lines().toList());
        lines.removeIf(line -> line.startsWith("warning: foobar.scene.journal: expected to be written, got "));
        assertEquals(1, lines.size(), printed);
        assertTrue(lines.get(0).startsWith("foobar.scene: expected to be written, got "), printed);
        assertEquals("the old file", Files.readString(output));
    }

    private List<String> onTerminal(String key, String after, List<String> command) throws Exception {
        assumeTrue(hasPython(), "needs python3 for a pseudo terminal");
        Path script = Path.of(StopTest.class.getResource("press-key.py").toURI());
        List<String> all = new ArrayList<>(List.of("python3", script.toString(), key, after));
        all.addAll(command);
        return all;
    }

    private static boolean hasPython() throws InterruptedException {
        try {
            return new ProcessBuilder("python3", "-c", "import pty").start().waitFor() == 0;
        } catch (IOException e) {
            return false;
        }
    }

    /** The file is whole, and one more shot can be added to it. */
    private void goesOn(int leastShots) throws IOException {
        Path file = program.file("foobar.scene");
        int shots = SavedCalculation.read(file).shots();
        assertTrue(shots >= leastShots, "stopped after " + shots + " shots");
        Path more = program.file("more.scene");
        ProgramRun run = ProgramRun.of("-q", "-tf", file, shots, "-it", shots + 1, "-se", 0,
                program.file("foobar.lws"), more);
        assertEquals(ExitCode.DONE, run.exitCode(), run.err());
        assertEquals(shots + 1, SavedCalculation.read(more).shots());
    }
}
