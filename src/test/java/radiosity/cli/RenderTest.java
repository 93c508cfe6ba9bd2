package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.cli.options.ExitCode;
import radiosity.cli.render.SavedCalculation;
import radiosity.output.gltf.SceneFile;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Lamp;
import radiosity.testkit.ProgramRun;

/** What a render does with its options, its files and what goes wrong, on a coarse Cornell box. */
class RenderTest {

    private static final Path BOX = Path.of("scenes/cornell-box.lws");
    private static final String COARSE = "20000";

    @TempDir
    Path directory;

    private Path output;

    @BeforeEach
    void nameOutput() {
        output = directory.resolve("box.scene");
    }

    private ProgramRun render(Object... options) {
        Object[] all = new Object[options.length + 4];
        System.arraycopy(options, 0, all, 0, options.length);
        System.arraycopy(new Object[] {"-pa", COARSE, BOX, output}, 0, all, options.length, 4);
        return ProgramRun.of(all);
    }

    private static void succeeds(ProgramRun run) {
        assertEquals(ExitCode.DONE, run.exitCode(), run.err());
    }

    private static void fails(int exitCode, String line, ProgramRun run) {
        assertEquals(line + System.lineSeparator(), run.err());
        assertEquals(exitCode, run.exitCode());
        assertEquals("", run.out());
    }

    @Test
    void iterations_areCountedExactly() throws IOException {
        succeeds(render("-q", "-it", 37));
        assertEquals(37, SavedCalculation.read(output).shots());
    }

    @Test
    void stopError_isReached() throws IOException {
        succeeds(render("-q", "-se", 0.3, "--report", directory.resolve("r.json")));
        JsonNode report = new ObjectMapper().readTree(directory.resolve("r.json").toFile());
        assertTrue(report.get("unsent").doubleValue() <= 0.3);
        assertTrue(report.get("shots").intValue() > 1);
        assertTrue(report.get("certificate").get("expected").doubleValue() > 0);
        JsonNode surfaces = report.get("certificate").get("surfaces");
        assertTrue(surfaces.size() > 1);
        assertEquals(1, StreamSupport.stream(surfaces.spliterator(), false)
                .mapToDouble(surface -> surface.get("share").doubleValue()).sum(), 1e-12);
    }

    /** The box has one lamp and, made to count, no light: its one layer is the whole. */
    @Test
    void layers_areKeptAndGoneOnWith() throws IOException {
        succeeds(render("-q", "--layers", "-it", 5));
        try (SceneFile scene = SceneFile.open(output)) {
            assertEquals(List.of("light"), scene.lamps().stream().map(Lamp::name).toList());
            for (Mesh mesh : scene.meshes()) {
                assertArrayEquals(mesh.irradiance(), mesh.layers().get(0));
            }
        }
        Path more = directory.resolve("more.scene");
        succeeds(ProgramRun.of("-q", "-tf", output, 5, "-it", 9, BOX, more));
        try (SceneFile scene = SceneFile.open(more)) {
            assertEquals(1, scene.lamps().size(), "goes on with layers");
        }
    }

    @Test
    void disableRendering_savesWhatIsThereBeforeTheFirstShot() throws IOException {
        succeeds(render("-dr"));
        assertEquals(0, SavedCalculation.read(output).shots());
        try (SceneFile scene = SceneFile.open(output)) {
            assertEquals(0, scene.ledger().shot()[0]);
        }
    }

    @Test
    void resuming_givesTheSameStateAsNoStop() throws IOException {
        succeeds(render("-q", "-it", 30, "-mt", 5));
        Path more = directory.resolve("more.scene");
        succeeds(ProgramRun.of("-q", "-tf", output, 30, "-it", 60, BOX, more));
        succeeds(render("-q", "-it", 60, "-mt", 5));
        assertEquals(SavedCalculation.read(output).state(), SavedCalculation.read(more).state());
    }

    @Test
    void resumingWithoutANumber_takesTheFiles() throws IOException {
        succeeds(render("-q", "-it", 30));
        Path numbered = directory.resolve("numbered.scene");
        succeeds(ProgramRun.of("-q", "-tf", output, 30, "-it", 60, BOX, numbered));
        Path more = directory.resolve("more.scene");
        succeeds(ProgramRun.of("-q", "-tf", output, "-it", 60, BOX, more));
        assertEquals(60, SavedCalculation.read(more).shots());
        assertEquals(SavedCalculation.read(numbered).state(), SavedCalculation.read(more).state());
    }

    @Test
    void resuming_saysWhereMoreShotsAreThereThanAreWanted() throws IOException {
        succeeds(render("-q", "-it", 10));
        ProgramRun run = ProgramRun.of("-q", "-tf", output, "-it", 5, BOX, directory.resolve("more.scene"));
        succeeds(run);
        assertTrue(run.err().contains("-it: expected a saved calculation of at most 5 shots to go on from, got 10"),
                run.err());
    }

    @Test
    void resuming_mayOverwriteTheFileItComesFrom() throws IOException {
        succeeds(render("-q", "-it", 10));
        succeeds(ProgramRun.of("-q", "-tf", output, 10, "-it", 20, BOX, output));
        assertEquals(20, SavedCalculation.read(output).shots());
    }

    @Test
    void resuming_needsTheSameNumberAndSettings() {
        succeeds(render("-q", "-nr", 5, "-it", 10));
        Path more = directory.resolve("more.scene");
        fails(ExitCode.COMMAND_LINE, "-tf: expected 10, with which " + output + " was saved, got 11",
                ProgramRun.of("-tf", output, 11, BOX, more));
        fails(ExitCode.COMMAND_LINE, "-pa: expected 20000.0, with which " + output + " was made, got 1000.0",
                ProgramRun.of("-pa", 1000, "-tf", output, 10, BOX, more));
        fails(ExitCode.COMMAND_LINE, "-nr: expected 5, with which " + output + " was made, got 9",
                ProgramRun.of("-nr", 9, "-tf", output, 10, BOX, more));
        fails(ExitCode.COMMAND_LINE, "-mt: expected none, with which " + output + " was made, got 3.0",
                ProgramRun.of("-mt", 3, "-tf", output, 10, BOX, more));
        fails(ExitCode.COMMAND_LINE, "--schedule: expected paper, with which " + output + " was made, got gathering",
                ProgramRun.of("--schedule", "gathering", "-tf", output, 10, BOX, more));
        assertFalse(Files.exists(more));
    }

    @Test
    void resumingWithAnotherAccuracy_isToldInPerCent() {
        succeeds(render("-q", "--schedule", "predict", "--accuracy", "2%", "-dr"));
        fails(ExitCode.COMMAND_LINE, "--accuracy: expected 2%, with which " + output + " was made, got 10%",
                ProgramRun.of("--accuracy", "10%", "-tf", output, 0, BOX, directory.resolve("more.scene")));
    }

    @Test
    void resumingAnotherScene_isExitCode3() {
        succeeds(render("-q", "-it", 10));
        ProgramRun run = ProgramRun.of("-tf", output, 10, "scenes/cornell-box-empty.lws",
                directory.resolve("more.scene"));
        assertEquals(ExitCode.FILE, run.exitCode());
        assertTrue(run.err().startsWith(output + " does not go on with cornell-box-empty.lws: the saved calculation: "
                + "expected the same scene and settings, got one of another scene"), run.err());
    }

    @Test
    void resumingWhatIsNoSceneFile_isExitCode3() throws IOException {
        Path other = Files.writeString(directory.resolve("other"), "no scene");
        ProgramRun run = ProgramRun.of("-tf", other, 10, BOX, output);
        assertEquals(ExitCode.FILE, run.exitCode());
        assertEquals(1, run.err().lines().count(), run.err());
    }

    @Test
    void saveInterval_savesAtEveryNthShot() throws IOException {
        succeeds(render("-q", "-si", 10, "-it", 35, "-sn", 15, "--size", "40x30"));
        assertEquals(35, SavedCalculation.read(output).shots());
        assertTrue(Files.exists(directory.resolve("box.scene-15.jpg")));
        assertTrue(Files.exists(directory.resolve("box.scene-30.jpg")));
        assertFalse(Files.exists(directory.resolve("box.scene-35.jpg")));
    }

    @Test
    void snapshotInterval_isKeptWithinRoundsOfManyShots() throws IOException {
        succeeds(ProgramRun.of("-q", "-pa", 2000, "-it", 170, "-sn", 50, "--size", "40x30", BOX, output));
        for (int shots = 50; shots < 170; shots += 50) {
            assertTrue(Files.exists(directory.resolve("box.scene-" + shots + ".jpg")), shots + " shots");
        }
    }

    /** One triangle's texture has room, those of the whole surface do not: that is found out at the end. */
    @Test
    void texturesThatAreTooLarge_doNotCostTheSolution() throws IOException {
        ProgramRun run = render("-q", "-it", 10, "-ut", 10);
        assertEquals(ExitCode.FILE, run.exitCode(), run.err());
        assertTrue(run.err().contains("expected a texture of at most 8192 texels"), run.err());
        assertEquals(10, SavedCalculation.read(output).shots());
    }

    @Test
    void longestName_isWrittenAndALongerOneRefusedBeforeAnyWork() throws IOException {
        Path longest = directory.resolve("a".repeat(251) + ".png");
        succeeds(render("-q", "-it", 10, "--size", "40x30", "--picture", longest));
        assertTrue(Files.size(longest) > 0);
        ProgramRun longer = render("--picture", directory.resolve("a".repeat(252) + ".png"));
        assertEquals(ExitCode.FILE, longer.exitCode());
        assertEquals(1, longer.err().lines().count(), longer.err());
    }

    @Test
    void pictures_areWrittenInEveryFormat() throws IOException {
        succeeds(render("-q", "-it", 10, "--size", "40x30", "--picture", directory.resolve("a.png"), "--picture",
                directory.resolve("a.jpg"), "--picture", directory.resolve("a.hdr")));
        byte[] png = Files.readAllBytes(directory.resolve("a.png"));
        assertEquals(40, ByteBuffer.wrap(png).getInt(16));
        assertEquals(30, ByteBuffer.wrap(png).getInt(20));
        assertEquals((byte) 0xD8, Files.readAllBytes(directory.resolve("a.jpg"))[1]);
        assertTrue(Files.readString(directory.resolve("a.hdr"), java.nio.charset.StandardCharsets.ISO_8859_1)
                .startsWith("#?RADIANCE"));
    }

    /** One ray of the paper's is too few for any accuracy. All is saved, and nothing is left to go on from. */
    @Test
    @Tag("slow")
    void accuracyThatIsNotReached_isExitCode5AndTheRenderIsDone() throws IOException {
        Path report = directory.resolve("report.json");
        Path journal = Files.writeString(directory.resolve("box.scene.journal"), "what another render left behind");
        ProgramRun run = ProgramRun.of("-q", "--accuracy", "5%", "-pa", 100_000, "--form-factors", "plain", "-nr", 1,
                "--report", report, BOX, output);
        assertEquals(5, run.exitCode(), run.err());
        assertTrue(run.err().matches("warning: .*; it is replaced\\R"
                + "accuracy not reached: expected an error of 5.0 %, got \\S+ %; .*\\R"), run.err());
        assertTrue(run.out().contains("radiosity +- "), run.out());
        assertTrue(SavedCalculation.read(output).shots() > 0);
        assertTrue(new ObjectMapper().readTree(report.toFile()).get("certificate").get("expected").doubleValue() > .05);
        assertFalse(Files.exists(journal), "the next render would find it");
    }

    @Test
    void points_getTheLightThatIsThere() throws IOException {
        Path in = Files.writeString(directory.resolve("in.csv"), "278,0,-280,0,1,0\n");
        Path out = directory.resolve("out.csv");
        succeeds(render("-q", "-it", 10, "--points", in, out));
        String[] values = Files.readAllLines(out).get(1).split(",");
        assertTrue(Double.parseDouble(values[6]) > 0, "irradiance on the floor");
    }

    @Test
    void wrongPoints_areToldBeforeTheRender() throws IOException {
        Path in = Files.writeString(directory.resolve("in.csv"), "1,2,3\n");
        ProgramRun run = render("--points", in, directory.resolve("out.csv"));
        assertEquals(ExitCode.FILE, run.exitCode(), run.err());
        assertEquals(1, run.err().lines().count(), run.err());
        assertFalse(Files.exists(output));
    }

    @Test
    void quiet_silencesProgressOnly() {
        ProgramRun run = render("-q", "-it", 5);
        assertEquals("", run.err());
        assertTrue(run.out().contains("5 shots in 3 rounds"), run.out());
        assertTrue(render("-it", 5).err().matches("(?s)(.*, )?distributing light, \\d+ %: 1 shot, .*"));
    }

    @Test
    void info_tellsWhatASceneFileHolds() {
        succeeds(render("-q", "-it", 5));
        ProgramRun info = ProgramRun.of("--info", output);
        succeeds(info);
        assertTrue(info.out().contains("5 in 3 rounds"), info.out());
    }

    @Test
    void missingInput_isExitCode3() {
        Path missing = directory.resolve("missing.lws");
        fails(ExitCode.FILE, missing + ": expected a readable file, got none", ProgramRun.of(missing, output));
        fails(ExitCode.FILE, missing + ": expected a readable file, got none", ProgramRun.of("--info", missing));
    }

    @Test
    void inputThatIsNoScene_isExitCode3() throws IOException {
        Path text = Files.writeString(directory.resolve("text.lws"), "not a scene");
        ProgramRun run = ProgramRun.of(text, output);
        assertEquals(ExitCode.FILE, run.exitCode());
        assertEquals(1, run.err().lines().count(), run.err());
        assertFalse(Files.exists(output));
    }

    /** "NaN" as a text would be one that is no number. */
    @ParameterizedTest
    @ValueSource(strings = {"-dr", "-it=10", "--accuracy=20%"})
    void report_hasOnlyNumbersWhereNumbersBelong(String option) throws IOException {
        Path report = directory.resolve("report.json");
        succeeds(render("-q", option, "--report", report));
        JsonNode json = new ObjectMapper().readTree(report.toFile());
        assertEquals(6, json.get("ledger").size());
        for (JsonNode flux : json.get("ledger")) {
            flux.forEach(channel -> assertTrue(channel.isNumber() && Double.isFinite(channel.doubleValue()),
                    json.toString()));
        }
        assertEquals(!option.equals("-dr"), json.has("certificate"));
        assertEquals(json.at("/certificate/missingFlux").isNumber(), json.has("missingFluxBound"));
        assertFalse(json.toString().contains("NaN") || json.toString().contains("Infinity"), json.toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"--help", "--version"})
    void helpAndVersion_needNothingElse(String option) {
        ProgramRun run = ProgramRun.of(option);
        succeeds(run);
        assertFalse(run.out().isBlank());
        assertEquals("", run.err());
    }

    @Test
    void sceneFile_remembersItsCommandLine() throws IOException {
        succeeds(render("-q", "-it", 3));
        try (SceneFile scene = SceneFile.open(output)) {
            assertEquals(List.of("-q", "-it", "3", "-pa", COARSE, BOX.toString(), output.toString()),
                    scene.extras().get("commandLine"));
        }
    }

    @Test
    void outputsThatWouldOverwriteEachOther_areExitCode2BeforeAnyWork() {
        Path journal = directory.resolve("box.scene.journal");
        fails(ExitCode.COMMAND_LINE, journal + ": expected a file of its own for each output, got the journal of "
                + output,
                render("--report", journal));
        Path snapshot = directory.resolve("box.scene-5.jpg");
        fails(ExitCode.COMMAND_LINE, snapshot + ": expected a file of its own for each output, got a snapshot (-sn) of "
                + output, render("-sn", 5, "--picture", snapshot));
        assertFalse(Files.exists(output));
    }

    @Test
    void fileToGoOnFrom_isOverwrittenByTheSceneFileOnly() {
        succeeds(render("-q", "-it", 10));
        fails(ExitCode.COMMAND_LINE, output + ": expected an output that is no input, got the same file as " + output,
                ProgramRun.of("-tf", output, 10, "--report", output, BOX, directory.resolve("more.scene")));
    }
}
