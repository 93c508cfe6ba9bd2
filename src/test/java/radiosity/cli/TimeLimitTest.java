package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntPredicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import radiosity.cli.options.ExitCode;
import radiosity.cli.options.Failure;
import radiosity.cli.options.RendererOptions;
import radiosity.cli.options.TimeLimit;
import radiosity.cli.options.Values;
import radiosity.cli.render.ConsoleSession;
import radiosity.cli.render.OutputFiles;
import radiosity.cli.render.RenderJob;
import radiosity.cli.render.RenderResult;
import radiosity.cli.render.SavedCalculation;
import radiosity.cli.render.TimedCalculation;
import radiosity.cli.render.Warnings;
import radiosity.cli.terminal.ProgressText;
import radiosity.cli.terminal.StopRequest;
import radiosity.cli.terminal.TimeCourse;
import radiosity.input.SceneReader;
import radiosity.scene.Scene;
import radiosity.solution.Progress;
import radiosity.solution.SavedState;
import radiosity.testkit.Program;
import radiosity.testkit.ProgramRun;

/** {@code --time}: the clock chooses the accuracy and never the bits. */
@Tag("slow")
class TimeLimitTest {

    private static final String FILES = " foobar.lws foobar.scene";

    @TempDir
    Path directory;

    @ParameterizedTest
    @CsvSource({"60s, 60", "1ms, .001", "2m, 120", "2min, 120", "1.5h, 5400", "90, 90"})
    void units_areSeconds(String text, double seconds) {
        assertEquals(seconds, new TimeLimit.Parser().parse(text).seconds(), 1e-12);
    }

    @ParameterizedTest
    @CsvSource({".5, 50%", ".0137, 1.37%", ".01234567, 1.24%", ".0001, 0.01%", ".003, 0.3%"})
    void accuracy_isWrittenWithThreeDigits_notFiner(double accuracy, String expected) {
        assertEquals(expected, TimeLimit.perCent(accuracy));
        assertTrue(new Values.PerCent().parse(expected) >= accuracy * (1 - 1e-15));
    }

    @Test
    void commandLine_namesTheAccuracyInsteadOfTheTime() {
        assertEquals(List.of("-q", "--accuracy", "2%", "a", "b"),
                TimeLimit.reproducing(List.of("-q", "--time", "60s", "a", "b"), TimeLimit.accuracy("2%")));
        assertEquals(List.of("a", "--iterations", "9", "b", "--accuracy", "5%,2%", "--estimates", "3"),
                TimeLimit.reproducing(List.of("a", "--iterations", "9", "--estimates=7", "b", "--time=60s"),
                        TimeLimit.estimates("5%,2%", 3)));
    }

    @Test
    void progress_showsTheTimeThatIsLeft() {
        TimeCourse course = new TimeCourse(60, () -> 20);
        course.at("3%");
        ProgressText text = new ProgressText(course);
        text.show(new Progress(5, 3, 0.5, 1234, false));
        assertEquals("at 3%: distributing light, 33 %: 5 shots, 50 % not yet distributed, 1,234 mesh elements,"
                + " 40 s left", text.line());
        assertEquals(1 / 3.0, course.done(new Progress(5, 3, 0.5, 1234, false)), 1e-12);
    }

    /** In this process the time is over from the start: it is cut off as soon as there is some light. */
    @ParameterizedTest
    @ValueSource(strings = {"", "--layers", "--schedule predict -it 100000"})
    void tooShort_isCutOffAsByTheOptionsThatArePrinted(String others) throws IOException {
        Program program = new Program(directory);
        Path output = program.file("foobar.scene");
        ProgramRun run = run(others + " --time 1ms", program);
        assertEquals(ExitCode.DONE, run.exitCode(), run.err());
        assertTrue(run.err().contains("--time 1ms: too short for this scene; going on until"), run.err());
        Matcher same = Pattern.compile("too short for this scene, cut off after .*; the same as with (--.*)")
                .matcher(run.out());
        assertTrue(same.find(), run.out());
        SavedState timed = SavedCalculation.read(output).state();
        ProgramRun again = run(same.group(1) + (others.equals("--layers") ? " --layers" : ""), program);
        assertEquals(ExitCode.DONE, again.exitCode(), again.err());
        assertEquals(timed, SavedCalculation.read(output).state());
        Matcher unsent = Pattern.compile("(\\S+) % of the light not yet distributed").matcher(run.out());
        assertTrue(unsent.find() && Double.parseDouble(unsent.group(1)) <= 50, run.out());
    }

    private static ProgramRun run(String options, Program program) {
        List<Object> arguments = new ArrayList<>(List.of("-q", "-pa", "5000"));
        arguments.addAll(List.of(options.strip().split(" ")));
        arguments.addAll(List.of(program.file("foobar.lws"), program.file("foobar.scene")));
        return ProgramRun.of(arguments.toArray());
    }

    /** The limit ends at every look at the clock, so also at those after elements were divided, and in estimates. */
    @Test
    void cutOffAtAnyLook_isTheSameAsByTheOptionsThatArePrinted() throws IOException {
        Program program = new Program(directory);
        Map<String, SavedState> byOptions = new TreeMap<>();
        for (int looks = 1; looks < 30; looks++) {
            int[] looked = {0};
            int last = looks;
            Timed timed = new Timed(program.file("foobar.lws"), program.file("foobar.scene"),
                    kept -> ++looked[0] < last);
            if (!byOptions.containsKey(timed.options)) {
                byOptions.put(timed.options, state(timed, program));
            }
            assertEquals(byOptions.get(timed.options), timed.result.solution().state(), "after " + looks + " looks");
        }
        assertTrue(byOptions.keySet().stream().anyMatch(options -> options.contains(" -it ")), byOptions.toString());
    }

    /** What is kept before an accuracy is reached is the solution of an estimate: the first one of the study at 20 %. */
    @Test
    void cutOffAfterAnEstimate_isTheSameAsByTheOptionsThatArePrinted() throws IOException {
        Program program = new Program(directory);
        Timed timed = new Timed(Path.of("scenes/study.lws").toAbsolutePath(), program.file("foobar.scene"),
                kept -> kept < 1);
        assertTrue(timed.options.matches("--accuracy \\S+ --estimates \\d"), timed.options);
        assertEquals(timed.result.solution().state(), SavedCalculation.read(program.file("foobar.scene")).state());
        assertEquals(timed.result.solution().state(), state(timed, program));
    }

    /** The directory of the scene file is missing until the end, so the first save fails. */
    @Test
    void saveThatFailsOnTheWay_endsNothing_andIsTriedAgainAtTheEnd() throws IOException {
        Path output = directory.resolve("missing").resolve("foobar.scene");
        Program program = new Program(directory);
        Timed timed = new Timed(program.file("foobar.lws"), output, kept -> kept < 1);
        assertEquals(1, timed.err.toString().lines().filter(line -> line.startsWith(output + ": expected")).count(),
                timed.err::toString);
        assertEquals(ExitCode.FILE, assertThrows(Failure.class, timed.calculation::save).exitCode());
        Files.createDirectory(output.getParent());
        timed.calculation.save();
        assertEquals(timed.result.solution().state(), SavedCalculation.read(output).state());
    }

    private static SavedState state(Timed timed, Program program) throws IOException {
        List<Object> arguments = new ArrayList<>(timed.arguments);
        arguments.addAll(List.of(timed.options.split(" ")));
        ProgramRun again = ProgramRun.of(arguments.toArray());
        assertEquals(ExitCode.DONE, again.exitCode(), again.err());
        return SavedCalculation.read(program.file("foobar.scene")).state();
    }

    /** A calculation by a clock that goes on until something was looked at or kept often enough. */
    private static final class Timed {

        private final List<String> arguments;
        private final RenderResult result;
        /** The options that are printed. */
        private final String options;
        private TimedCalculation calculation;
        private RenderResult seen;
        private int kept;
        private final ByteArrayOutputStream err = new ByteArrayOutputStream();

        /** @param goesOn whether time is left after a number of solutions that were kept */
        Timed(Path input, Path output, IntPredicate goesOn) throws IOException {
            arguments = List.of("-q", "-pa", "5000", input.toString(), output.toString());
            List<String> withTime = new ArrayList<>(arguments);
            withTime.addAll(List.of(TimeLimit.OPTION, "1s"));
            RendererOptions parsed = new RendererOptions();
            new CommandLine(parsed).parseArgs(withTime.toArray(new String[0]));
            StopRequest stop = new StopRequest();
            PrintStream lines = new PrintStream(err, true);
            ConsoleSession user = new ConsoleSession(lines, lines::println, stop);
            OutputFiles files = new OutputFiles(parsed, withTime);
            Scene scene = SceneReader.read(parsed.input(), parsed.scene.readOptions(),
                    new Warnings(line -> { }, false)::print);
            calculation = new TimedCalculation(new RenderJob(parsed, scene, files, new Warnings(line -> { }, false),
                    user), parsed.calculation.settings(scene, parsed.calculation.defaults()), parsed.calculation.time,
                    new TimeCourse(1, () -> goesOn.test(kept()) ? 0 : 2), user, stop, files);
            result = calculation.run();
            Matcher same = Pattern.compile("the same as with (--.*)").matcher(calculation.summary());
            assertTrue(same.find(), calculation.summary());
            options = same.group(1);
        }

        private int kept() {
            RenderResult now = calculation.kept().orElse(null);
            kept += now == seen ? 0 : 1;
            seen = now;
            return kept;
        }
    }

    @Test
    void commandLine_namesTheShotsAfterWhichItWasCutOff() {
        List<String> options = List.of("--schedule", "predict", "--accuracy", "50%", "-it", "7");
        for (String given : List.of("--time 60s -q a b", "--time=60s -it 9 -q a b",
                "--iterations=9 --schedule=predict --time 60s -q a b")) {
            List<String> expected = new ArrayList<>(options);
            expected.addAll(List.of("-q", "a", "b"));
            assertEquals(expected, TimeLimit.reproducing(List.of(given.split(" ")), TimeLimit.cutOff("50%", 7)));
        }
    }

    /** Where the machine is too slow for the first calculation, light is the same; only the certificate is new. */
    @ParameterizedTest
    @ValueSource(strings = {"-q --time 8s", "--time=8s --srgb -q"})
    void sceneFile_isTheSameAsWithTheOptionsThatArePrinted(String options) throws Exception {
        Program program = new Program(directory);
        Path output = program.file("foobar.scene");
        String told = rendered(program, "-pa 20000 " + options + FILES);
        Matcher same = Pattern.compile("the same as with (--.*\\S)").matcher(told);
        assertTrue(same.find(), told);
        byte[] timed = Files.readAllBytes(output);
        SavedState state = SavedCalculation.read(output).state();
        boolean isCutOff = told.contains("cut off after");
        rendered(program, "-pa 20000 " + options.replaceFirst("--time.8s", same.group(1)) + FILES);
        assertEquals(state, SavedCalculation.read(output).state());
        if (!isCutOff) {
            assertArrayEquals(timed, Files.readAllBytes(output));
        }
    }

    private static String rendered(Program program, String arguments) throws Exception {
        Process render = program.start(arguments);
        String told = Program.rest(render);
        assertEquals(ExitCode.DONE, render.waitFor(), told);
        return told;
    }

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no signals")
    void stoppedInALaterCalculation_theLastWholeSolutionStays() throws Exception {
        Program program = new Program(directory);
        Process render = program.start("--time 1000s" + FILES);
        BufferedReader shown = render.inputReader();
        String line = shown.readLine();
        while (line != null && (line.startsWith("at 20%") || !line.startsWith("at "))) {
            assertTrue(line.startsWith("reading ") || line.endsWith(" left") || line.matches("at 20%: [ a-z.]+"), line);
            line = shown.readLine();
        }
        new ProcessBuilder("kill", Long.toString(render.pid())).start().waitFor();
        String rest = shown.lines().collect(Collectors.joining("\n"));
        assertEquals(143, render.waitFor(), rest);
        assertTrue(rest.contains("stopped after ") && rest.contains("; the same as with --accuracy "), rest);
        assertTrue(rest.contains("radiosity +- "), "certified: " + rest);
    }
}
