package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.options.CalculationOptions;
import radiosity.cli.options.CommandLineParser;
import radiosity.cli.options.ExitCode;
import radiosity.cli.options.FileOptions;
import radiosity.cli.options.RendererOptions;
import radiosity.cli.render.SavedCalculation;
import radiosity.output.gltf.SceneFile;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.testkit.Program;

/** Appendix C of the paper word for word, with foobar.lws a Cornell box. */
@Tag("slow")
@Timeout(value = 5, unit = TimeUnit.MINUTES, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class PaperCommandsTest {

    @TempDir
    Path directory;

    private static RendererOptions parse(String commandLine) {
        RendererOptions options = new RendererOptions();
        new CommandLineParser(options).parse(commandLine.split(" "));
        return options;
    }

    private static RadiositySettings settings(String commandLine) {
        CalculationOptions calculation = parse(commandLine).calculation;
        return calculation.settings(null, calculation.defaults());
    }

    /** Section C.2. */
    @Test
    void localMode_rendersAsThePaperHasIt() throws Exception {
        Program program = new Program(directory);
        Process render = program.start("-pa 1000 -nr 5 foobar.lws foobar.scene");
        String printed = Program.rest(render);
        assertEquals(ExitCode.DONE, render.waitFor(), printed);
        SavedCalculation saved = SavedCalculation.read(program.file("foobar.scene"));
        assertEquals(1000, saved.settings().patchArea());
        assertEquals(5, saved.settings().rays());
        try (SceneFile scene = SceneFile.open(program.file("foobar.scene"))) {
            assertTrue(scene.ledger().absorbed()[0] > 0);
        }
    }

    /** Section C.3. */
    @Test
    void distributedMode_takesTheHosts() {
        RendererOptions options = parse("-pa 1000 -nr 5 -h 3 andreas daniel igge foobar.lws foobar.scene");
        assertEquals("[andreas, daniel, igge]", options.host.hosts.toString());
        assertEquals(List.of(Path.of("foobar.lws"), Path.of("foobar.scene")), options.files);
    }

    /** Section C.7: -mx256m is -Xmx256m in today's Java. */
    @Test
    void memory_canBeGivenToJava() throws Exception {
        Program program = new Program(directory);
        List<String> command = Program.command("-dr foobar.lws foobar.scene");
        command.add(1, "-Xmx256m");
        Process render = program.start(command);
        String printed = Program.rest(render);
        assertEquals(ExitCode.DONE, render.waitFor(), printed);
    }

    @Test
    void tooLittleMemory_isToldInOneLine() throws Exception {
        Program program = new Program(directory);
        List<String> command = Program.command("-q -pa 9 foobar.lws foobar.scene");
        command.add(1, "-Xmx32m");
        Process render = program.start(command);
        String printed = Program.rest(render);
        assertEquals(ExitCode.FAILED, render.waitFor(), printed);
        assertTrue(printed.startsWith("memory: expected more than "), printed);
        assertEquals(1, printed.lines().count(), printed);
        assertFalse(Files.exists(program.file("foobar.scene")));
    }

    @Test
    void dr_disablesRendering() {
        assertTrue(parse("-dr foobar.lws foobar.scene").file.disableRendering);
    }

    @Test
    void it_stopsAfterNIterations() {
        assertEquals(200, parse("-it 200 foobar.lws foobar.scene").calculation.stopRule().shots());
    }

    @Test
    void mt_isTheMeshingThreshold() {
        assertEquals(0.5, settings("-mt 0.5 foobar.lws foobar.scene").meshing());
        assertEquals(Double.POSITIVE_INFINITY, settings("foobar.lws foobar.scene").meshing());
    }

    @Test
    void nr_isTheNumberOfRays() {
        assertEquals(10, settings("-nr 10 foobar.lws foobar.scene").rays());
    }

    @Test
    void pa_isTheMaximalPatchArea() {
        assertEquals(1000, settings("-pa 1000 foobar.lws foobar.scene").patchArea());
    }

    @Test
    void q_isQuiet() {
        assertTrue(parse("-q foobar.lws foobar.scene").quiet);
    }

    @Test
    void se_stopsWhenSoMuchFluxIsLeft() {
        RendererOptions options = parse("-se 0.05 foobar.lws foobar.scene");
        assertEquals(0.05, options.calculation.stopRule().unsent());
        assertEquals(Schedule.PAPER, settings("-se 0.05 foobar.lws foobar.scene").schedule());
    }

    @Test
    void si_savesAtEveryNthIteration() {
        assertEquals(100, parse("-si 100 foobar.lws foobar.scene").file.saveInterval);
    }

    @Test
    void sn_takesASnapshotAtEveryNthIteration() {
        assertEquals(100, parse("-sn 100 foobar.lws foobar.scene").picture.snapshotInterval);
    }

    @Test
    void tf_goesOnFromASceneFile() {
        FileOptions.Resume resume = parse("-tf f 200 -it 400 foobar.lws foobar.scene").file.resume;
        assertEquals(Path.of("f"), resume.file());
        assertEquals(OptionalInt.of(200), resume.shots());
    }

    @Test
    void ut_takesTheNumberOfSamples() {
        assertEquals(2, parse("-ut 2 foobar.lws foobar.scene").textures);
    }
}
