package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.cli.options.ExitCode;
import radiosity.cli.render.SavedCalculation;
import radiosity.testkit.Program;
import radiosity.testkit.ProgramRun;

/** Options at their limits, by the command line: a result or one line. */
@Tag("slow")
class LimitsTest {

    @TempDir
    Path directory;

    private ProgramRun render(String options) {
        List<Object> all = new ArrayList<>(List.of((Object[]) options.split(" ")));
        all.addAll(List.of("-q", "scenes/cornell-box.lws", directory.resolve("box.scene")));
        return ProgramRun.of(all.toArray());
    }

    @ParameterizedTest
    @ValueSource(strings = {"-pa 20000 -nr 1 -it 3", "-pa 1e30 -it 3", "-pa 20000 -mt 0 -it 2",
        "-pa 20000 -se 1", "-pa 20000 -it 0", "--accuracy 50%"})
    void limit_givesAScene(String options) {
        ProgramRun run = render(options);
        assertEquals(ExitCode.DONE, run.exitCode(), run.err());
        assertEquals("", run.err());
        assertTrue(run.out().contains("elements"), run.out());
    }

    @Test
    void shortestTimeLimit_givesASceneAndALineThatItIsTooShort() {
        ProgramRun run = render("--time 1ms");
        assertEquals(ExitCode.DONE, run.exitCode(), run.err());
        assertEquals("--time 1ms: too short for this scene; going on until half of its light is distributed",
                run.err().strip());
        assertTrue(run.out().contains("elements"), run.out());
    }

    @ParameterizedTest
    @ValueSource(strings = {"-pa 0", "-pa -1", "-pa nan", "-pa 101%", "-nr 0", "-mt -1", "-se 1.1", "-se -1", "-it -1",
        "--accuracy 0%", "--time 0s", "-pa 1e-30", "-pa 1e-300"})
    void beyondIt_isRefusedInOneLineBeforeAnyWork(String options) {
        ProgramRun run = render(options);
        assertEquals(ExitCode.COMMAND_LINE, run.exitCode(), run.err());
        assertEquals(1, run.err().lines().count(), run.err());
        assertTrue(run.err().contains("expected"), run.err());
        assertFalse(run.err().contains("internal error"), run.err());
    }

    /** Memory that is enough to begin with, and not for what comes: 3 million elements in 200 MiB. */
    @Test
    void heapThatIsTooSmall_endsWithALineThatSaysWhatToGive() throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(
                Program.command("-q -it 1 -pa 0.0001% foobar.lws foobar.scene"));
        command.add(1, "-Xmx200m");
        Process process = new Program(directory).start(command);
        String printed = Program.rest(process);
        assertEquals(ExitCode.FAILED, process.waitFor(), printed);
        assertEquals(1, printed.lines().count(), printed);
        assertTrue(printed.contains("JAVA_OPTS=-Xmx"), printed);
    }

    /** Tens of millions of texels in 120 MiB. */
    @Test
    void heapThatIsTooSmallForTextures_doesNotCostTheSceneFile() throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(Program.command("-q -it 3 -pa 5% -ut 3 foobar.lws foobar.scene"));
        command.add(1, "-Xmx120m");
        Program program = new Program(directory);
        Process process = program.start(command);
        String printed = Program.rest(process);
        assertEquals(ExitCode.FAILED, process.waitFor(), printed);
        assertTrue(printed.contains("JAVA_OPTS=-Xmx"), printed);
        assertEquals(3, SavedCalculation.read(program.file("foobar.scene")).shots());
    }

    /** Points for which there is room, but not for the light at them, in 64 MiB. */
    @Test
    void heapThatIsTooSmallForAGrid_doesNotCostTheReport() throws IOException, InterruptedException {
        Program program = new Program(directory);
        List<String> command = new ArrayList<>(Program.command("-q -it 3 -pa 5% --spacing .85 --grid green grid.csv"
                + " --report report.json foobar.lws foobar.scene"));
        command.add(1, "-Xmx64m");
        Process process = program.start(command);
        String printed = Program.rest(process);
        assertEquals(ExitCode.FAILED, process.waitFor(), printed);
        assertTrue(printed.contains("grid.csv: expected to be written, got memory: "), printed);
        assertTrue(new ObjectMapper().readTree(program.file("report.json").toFile()).has("certificate"), printed);
    }

    /** 400,000 lines of 120 characters in 64 MiB. */
    @Test
    void pointsThatAreMoreThanTheHeapHolds_areWrittenAllTheSame() throws IOException, InterruptedException {
        Program program = new Program(directory);
        Files.writeString(program.file("points.csv"), "200,0,-200,0,1,0\n".repeat(400_000));
        List<String> command = new ArrayList<>(Program.command(
                "-q -it 3 -pa 5% --points points.csv light.csv foobar.lws foobar.scene"));
        command.add(1, "-Xmx64m");
        Process process = program.start(command);
        String printed = Program.rest(process);
        assertEquals(ExitCode.DONE, process.waitFor(), printed);
        try (Stream<String> lines = Files.lines(program.file("light.csv"))) {
            assertEquals(400_001, lines.count());
        }
    }
}
