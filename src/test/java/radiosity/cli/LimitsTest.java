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
import java.util.StringJoiner;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
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

    /** A grid of n x n vertices as OBJ. */
    private static String obj(int n) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < n * n; i++) {
            text.append("v ").append(i / n).append(".00001 0.0000001 ").append(i % n).append(".00001\n");
        }
        for (int i = 0; i < n * n - n; i++) {
            if (i % n < n - 1) {
                text.append("f ").append(i + 1).append(' ').append(i + 2).append(' ').append(i + n + 2).append(' ')
                        .append(i + n + 1).append('\n');
            }
        }
        return text.toString();
    }

    /** Five triangle meshes; the vertices of each are in a buffer of its own, or zeros where there is no buffer. */
    private static String gltf(boolean hasBuffers, int vertices) {
        StringJoiner primitives = new StringJoiner(",");
        StringJoiner accessors = new StringJoiner(",");
        StringJoiner views = new StringJoiner(",");
        StringJoiner buffers = new StringJoiner(",");
        for (int i = 0; i < 5; i++) {
            primitives.add("{\"attributes\":{\"POSITION\":" + i + "}}");
            accessors.add("{\"componentType\":5126,\"type\":\"VEC3\",\"count\":" + vertices
                    + (hasBuffers ? ",\"bufferView\":" + i : "") + "}");
            views.add("{\"byteLength\":1200,\"buffer\":" + i + "}");
            buffers.add("{\"byteLength\":4000000,\"uri\":\"" + i + ".bin\"}");
        }
        return """
                {"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"accessors":[%s],
                "meshes":[{"primitives":[%s]}],"bufferViews":[%s],"buffers":[%s]}
                """.formatted(accessors, primitives, views, buffers);
    }

    private static String model(String name) {
        return switch (name) {
            case "large.obj" -> obj(310);
            case "buffers.gltf" -> gltf(true, 99);
            case "zeros.gltf" -> gltf(false, 900_000);
            default -> gltf(true, 99).replace("{\"asset\"", "{\"extras\":[" + "0,".repeat(1_500_000) + "0],\"asset\"");
        };
    }

    private static Process start(Program program, String heap, String file) throws IOException {
        List<String> command = new ArrayList<>(Program.command("-q -dr " + file + " foobar.scene"));
        command.add(1, heap);
        return program.start(command);
    }

    /** In 64 MiB; with what the line says to give, the OBJ file is read. */
    @ParameterizedTest
    @ValueSource(strings = {"large.obj", "buffers.gltf", "zeros.gltf", "values.gltf"})
    void modelThatIsTooLargeForTheHeap_endsWithALineThatSaysWhatToGive(String file) throws Exception {
        Program program = new Program(directory);
        for (int i = 0; i < 5; i++) {
            Files.write(program.file(i + ".bin"), new byte[4_000_000]);
        }
        Files.writeString(program.file(file), model(file));
        Process process = start(program, "-Xmx64m", file);
        String printed = Program.rest(process);
        assertEquals(ExitCode.FILE, process.waitFor(), printed);
        assertEquals(1, printed.lines().count(), printed);
        assertTrue(printed.startsWith(file) && printed.contains(": expected "), printed);
        Matcher advice = Pattern.compile("give, say, JAVA_OPTS=(-Xmx\\d+m)").matcher(printed);
        assertTrue(advice.find(), printed);
        if (file.endsWith(".obj")) {
            String after = Program.rest(start(program, advice.group(1), file));
            assertTrue(after.contains("large.obj: expected a light or a surface that emits, got none"), after);
        }
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
