package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.cli.options.CommandRun;
import radiosity.cli.options.ServerOptions;
import radiosity.testkit.ProgramRun;

/** What the programs say, word for word. */
class WordsTest {

    private static final Path BOX = Path.of("scenes/cornell-box.lws");

    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource({"--lights=auto, W/m2 x unit2", "--unit=mm, W", "--photometric, lm/m2 x unit2"})
    void summary_saysHowExactAndHowConsistentTheLightIs(String option, String flux) {
        ProgramRun run = ProgramRun.of("-q", option, "-pa", 20000, "-it", 40, BOX, folder.resolve("box.scene"));
        assertEquals(0, run.exitCode(), run.err());
        List<String> lines = run.out().lines().toList();
        assertEquals(4, lines.size(), run.out());
        assertTrue(lines.get(0).matches("\\S+ mesh elements, initial patches <= 2\\.000e\\+04 units², 40 shots in \\d+ rounds,"
                + " \\S+ % of the light not yet distributed or shot too much, \\S+ .*"), lines.get(0));
        assertTrue(lines.get(1).matches("emitted \\S+ " + flux + " = absorbed \\S+ \\+ not yet distributed \\S+ \\+"
                + " (escaped or lost \\S+|escaped \\S+ \\+ lost \\S+)"), lines.get(1));
        assertTrue(lines.get(2).matches("radiosity \\+- \\S+ % \\(.*\\), estimated at \\d+ points; upper bound on missing flux:"
                + " more than is emitted"), lines.get(2));
        assertTrue(lines.get(3).matches("mean form-factor sum 0\\.\\d{4}, largest 1\\.\\d{4}, reciprocity error \\S+ %"),
                lines.get(3));
    }

    @ParameterizedTest
    @CsvSource({"--lights=auto, W/m2 x unit2", "--unit=mm, W", "--photometric, lm/m2 x unit2"})
    void boundOnMissingFlux_isSaidWhereItIsOfUse(String option, String flux) {
        ProgramRun run = ProgramRun.of("-q", option, "-pa", 20000, "--accuracy", "20%", BOX, folder.resolve("box.scene"));
        assertEquals(0, run.exitCode(), run.err());
        assertTrue(run.out().lines().toList().get(2).matches(".*; upper bound on missing flux: [\\d.e+-]+ " + flux),
                run.out());
    }

    @ParameterizedTest
    @CsvSource({"1, 1 triangle is too small to be lit; it still casts shadows",
        "2, 2 triangles are too small to be lit; they still cast shadows"})
    void trianglesTooSmallToBeLit_areCounted(int count, String words) throws IOException {
        StringBuilder obj = new StringBuilder("mtllib a.mtl\nusemtl lamp\nv 0 0 20\nv 9 0 20\nv 0 9 20\nf 3 2 1\n"
                + "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 4 5 6\n");
        for (int i = 0; i < count; i++) {
            int z = i + 1;
            obj.append("v 0 0 " + z + "\nv 1e-9 0 " + z + "\nv 0 1e-9 " + z + "\nf -3 -2 -1\n");
        }
        Files.writeString(folder.resolve("a.mtl"), "newmtl lamp\nKd .5 .5 .5\nKe 1 1 1\n");
        Path scene = Files.writeString(folder.resolve("a.obj"), obj);
        ProgramRun run = ProgramRun.of("-q", "-dr", scene, folder.resolve("a.scene"));
        assertEquals(0, run.exitCode(), run.err());
        assertEquals("warning: a.obj: " + words, run.err().strip());
    }

    /** A tetrahedron below a lamp, with the corners of its faces in either order. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', nullValues = "none", value = {"f 1 3 2;f 1 2 4;f 1 4 3;f 2 3 4 | none",
        "f 2 3 1;f 4 2 1;f 3 4 1;f 4 3 2 | expected bodies that are seen from outside, got one inside out, which will be"
                + " black: vase; turn the polygons over, or make the surfaces two-sided"})
    void bodiesThatAreInsideOut_areNamed(String faces, String words) throws IOException {
        Files.writeString(folder.resolve("a.mtl"), "newmtl vase\nKd .5 .5 .5\nnewmtl lamp\nKe 1 1 1\n");
        Path scene = Files.writeString(folder.resolve("a.obj"), "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                + "usemtl vase\n" + faces.replace(';', '\n')
                + "\nv 0 9 0\nv 1 9 0\nv 0 9 1\nusemtl lamp\nf 5 6 7\n");
        ProgramRun run = ProgramRun.of("-q", "-dr", scene, folder.resolve("a.scene"));
        assertEquals(0, run.exitCode(), run.err());
        assertEquals(words == null ? "" : "warning: a.obj: " + words, run.err().lines().findFirst().orElse(""));
    }

    private static String failing(int exitCode, String... arguments) {
        PrintStream err = System.err;
        ByteArrayOutputStream said = new ByteArrayOutputStream();
        System.setErr(new PrintStream(said, true, StandardCharsets.UTF_8));
        try {
            ServerOptions options = new ServerOptions();
            assertEquals(exitCode, CommandRun.of(options, options.common, () -> {
                throw new IllegalStateException("round 7:\n  failed");
            }, arguments));
        } finally {
            System.setErr(err);
        }
        return said.toString(StandardCharsets.UTF_8);
    }

    @Test
    void internalError_asksToBeReported() {
        String line = "internal error: java.lang.IllegalStateException: round 7: failed; please report it with the output"
                + " of --debug";
        assertEquals(line, failing(1).strip());
        String debugged = failing(1, "--debug");
        assertTrue(debugged.startsWith(line) && debugged.contains("\tat radiosity.cli.WordsTest"), debugged);
    }
}
