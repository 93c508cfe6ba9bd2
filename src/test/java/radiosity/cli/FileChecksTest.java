package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.options.ExitCode;
import radiosity.cli.options.Failure;
import radiosity.cli.render.FileChecks;
import radiosity.testkit.ProgramRun;

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
    void outputInPlaceOfAnImageOfTheScene_isExitCode2() throws IOException {
        Path image = written("floor.png", "image");
        checks.output(directory.resolve("b.scene"));
        checks.reserve(directory.resolve("b.scene.journal"), "the journal of b.scene");
        checks.reserveSnapshots(directory.resolve("b.scene"));
        assertDoesNotThrow(() -> checks.partOfScene(directory.resolve("other.png")));
        fails(ExitCode.COMMAND_LINE, "got a snapshot (-sn) of " + directory.resolve("b.scene"),
                () -> checks.partOfScene(directory.resolve("b.scene-10.jpg")));
        checks.output(image);
        fails(ExitCode.COMMAND_LINE, "floor.png: expected an output that is no input, got the same file as " + image,
                () -> checks.partOfScene(image));
        assertEquals("image", Files.readString(image));
    }

    @Test
    void sceneFileThatReplacesTheOneItGoesOnFrom_mayBeOfASceneWithImages() throws IOException {
        Path old = written("b.scene", "glTF");
        checks.output(old);
        checks.input(old);
        assertDoesNotThrow(() -> checks.partOfScene(directory.resolve("floor.png")));
    }

    @Test
    void renderOverAnImageOfItsScene_isOneLineAndExitCode2() throws IOException {
        BufferedImage painted = new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB);
        Path image = directory.resolve("floor.png");
        ImageIO.write(painted, "png", image.toFile());
        byte[] before = Files.readAllBytes(image);
        written("room.mtl", "newmtl floor\nKd .5 .5 .5\nKe 1 1 1\nmap_Kd floor.png\n");
        Path scene = written("room.obj", "mtllib room.mtl\nv 0 0 0\nv 1 0 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n"
                + "usemtl floor\nf 1/1 3/3 2/2\n");
        ProgramRun run = ProgramRun.of("-q", "-it", 1, "--picture", image, scene, directory.resolve("out.scene"));
        assertEquals(ExitCode.COMMAND_LINE, run.exitCode(), run.err());
        assertEquals(image + ": expected an output that is no input, got the same file as " + image,
                run.err().strip());
        assertArrayEquals(before, Files.readAllBytes(image));
    }

    @Test
    void outputInPlaceOfAnObject_isExitCode2() throws IOException {
        for (String name : new String[] {"room.obj", "ROOM.MTL", "room.bin", "lamp.ies", "lamp.LDT"}) {
            Path object = written(name, "v 0 0 0");
            fails(ExitCode.COMMAND_LINE, "expected a file to overwrite, got a part of a model",
                    () -> checks.output(object));
        }
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
