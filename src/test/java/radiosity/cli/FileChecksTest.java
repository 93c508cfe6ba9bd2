package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.options.ExitCode;
import radiosity.cli.options.Failure;
import radiosity.cli.render.FileChecks;

/** Files are looked at before any work, and nothing that exists is lost by a wrong command line. */
class FileChecksTest {

    @TempDir
    Path directory;

    private final FileChecks checks = new FileChecks();

    private Path written(String name, String text) throws IOException {
        return Files.writeString(directory.resolve(name), text);
    }

    private static void fails(int exitCode, String end, Runnable check) {
        Failure failure = assertThrows(Failure.class, check::run);
        assertTrue(failure.getMessage().endsWith(end), failure.getMessage());
        assertEquals(exitCode, failure.exitCode());
    }

    @Test
    void missingInput_isExitCode3() {
        fails(ExitCode.FILE, "a.lws: expected a readable file, got none",
                () -> checks.input(directory.resolve("a.lws")));
    }

    @Test
    void directoryAsInput_isExitCode3() {
        fails(ExitCode.FILE, "expected a file, got a directory", () -> checks.input(directory));
    }

    @Test
    void outputInAMissingDirectory_isExitCode3() {
        fails(ExitCode.FILE, "expected a directory that can be written, got none",
                () -> checks.output(directory.resolve("none/b.scene")));
    }

    @Test
    void directoryAsOutput_isExitCode3() {
        fails(ExitCode.FILE, "expected a file that can be written, got a directory", () -> checks.output(directory));
    }

    @Test
    void deviceAsOutput_isNotReplaced() {
        fails(ExitCode.FILE, "expected a file that can be written, got one that cannot",
                () -> checks.output(Path.of("/dev/null")));
    }

    @Test
    void outputThatIsTheInput_isExitCode2AndLeavesIt() throws IOException {
        Path input = written("a.lws", "scene");
        checks.input(input);
        fails(ExitCode.COMMAND_LINE, "got the same file as " + input, () -> checks.output(input));
        assertEquals("scene", Files.readString(input));
    }

    @Test
    void outputThatLinksToTheInput_isExitCode2() throws IOException {
        Path input = written("a.lws", "scene");
        Path link = Files.createSymbolicLink(directory.resolve("b.scene"), input);
        Path hard = Files.createLink(directory.resolve("c.scene"), input);
        checks.input(input);
        fails(ExitCode.COMMAND_LINE, "got the same file as " + input, () -> checks.output(link));
        fails(ExitCode.COMMAND_LINE, "got the same file as " + input, () -> checks.output(hard));
    }

    @Test
    void outputByAnotherSpelling_isTheSameFile() throws IOException {
        Path input = written("a.lws", "scene");
        checks.input(input);
        Path spelling = directory.resolve("../" + directory.getFileName() + "/a.lws");
        fails(ExitCode.COMMAND_LINE, "got the same file as " + input, () -> checks.output(spelling));
    }

    @Test
    void twoOutputsInOneFile_areExitCode2() {
        checks.output(directory.resolve("b.png"));
        fails(ExitCode.COMMAND_LINE, "expected a file of its own for each output, got one twice",
                () -> checks.output(directory.resolve("./b.png")));
    }

    @Test
    void lightWaveFileAsOutput_isNotOverwritten() throws IOException {
        Path object = written("a.lwo", "FORM....LWO2");
        Path scene = written("a.lws", "LWSC\n1\n");
        fails(ExitCode.COMMAND_LINE, "got a LightWave file", () -> checks.output(object));
        fails(ExitCode.COMMAND_LINE, "got a LightWave file", () -> checks.output(scene));
    }

    @Test
    void olderSceneFileAsOutput_isFineAndStaysUntilReplaced() throws IOException {
        Path output = written("b.scene", "glTF");
        assertDoesNotThrow(() -> checks.output(output));
        assertEquals("glTF", Files.readString(output));
        try (var files = Files.list(directory)) {
            assertEquals(1, files.count());
        }
    }

    @Test
    void outputInPlaceOfAFileThatTheProgramWritesBesides_isExitCode2() throws IOException {
        Path scene = directory.resolve("b.scene");
        checks.reserve(directory.resolve("b.scene.journal"), "the journal of " + scene);
        checks.reserveSnapshots(scene);
        fails(ExitCode.COMMAND_LINE, "got the journal of " + scene,
                () -> checks.output(directory.resolve("b.scene.journal")));
        fails(ExitCode.COMMAND_LINE, "got a snapshot (-sn) of " + scene,
                () -> checks.output(directory.resolve("./b.scene-20.jpg")));
        assertDoesNotThrow(() -> checks.output(directory.resolve("c.scene-20.jpg")));
    }

    @Test
    void journalInPlaceOfAnInput_isExitCode2() throws IOException {
        Path input = written("b.scene.journal", "LWSC");
        checks.input(input);
        fails(ExitCode.COMMAND_LINE, "got the same file as " + input,
                () -> checks.reserve(input, "the journal of b.scene"));
    }

    @Test
    void linkToNoFileYet_isTheFileThatItWillMake() throws IOException {
        Path link = Files.createSymbolicLink(directory.resolve("link.png"), Path.of("target.png"));
        checks.output(link);
        fails(ExitCode.COMMAND_LINE, "expected a file of its own for each output, got one twice",
                () -> checks.output(directory.resolve("target.png")));
        Path elsewhere = Files.createSymbolicLink(directory.resolve("elsewhere.png"), Path.of("none/target.png"));
        fails(ExitCode.FILE, "expected a directory that can be written, got none", () -> checks.output(elsewhere));
        Path circle = Files.createSymbolicLink(directory.resolve("circle.png"), Path.of("circle.png"));
        fails(ExitCode.FILE, "got a circle of symbolic links", () -> checks.output(circle));
    }
}
