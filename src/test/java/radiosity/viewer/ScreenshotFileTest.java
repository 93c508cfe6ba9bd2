package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.ViewSceneFile;
import radiosity.cli.options.ExitCode;
import radiosity.testkit.DirectoryChanges;
import radiosity.testkit.MountNamespace;
import radiosity.testkit.NeedsProgram;
import radiosity.testkit.Program;
import radiosity.testkit.Xvfb;

/** A screenshot is the old file or the new one, whole, whatever ends the viewer or keeps it from writing. */
@Tag("slow")
@NeedsProgram("Xvfb")
class ScreenshotFileTest {

    private static final String OLD = "the old file";
    private static final String NAME = "shot.png";

    @TempDir
    static Path folder;
    private static Path scene;

    @TempDir
    Path directory;
    private Path shots;
    private Path shot;

    @BeforeAll
    static void render() {
        scene = Rendered.cornellBox(folder).toAbsolutePath();
    }

    @BeforeEach
    void writeOld() throws IOException {
        shots = Files.createDirectory(directory.resolve("shots"));
        shot = Files.writeString(shots.resolve(NAME), OLD);
    }

    private ProcessBuilder viewer(Xvfb display, String file) {
        return display.program(ViewSceneFile.class, "--screenshot", file, "--size", "200x200", scene.toString())
                .directory(directory.toFile()).redirectErrorStream(true);
    }

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(shots)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    private boolean isNew() throws IOException {
        if (Arrays.equals(OLD.getBytes(), Files.readAllBytes(shot))) {
            return false;
        }
        BufferedImage picture = Rendered.picture(shot);
        assertNotNull(picture, "no picture of " + Files.size(shot) + " bytes");
        assertEquals(200, picture.getHeight());
        return true;
    }

    /** Killed when it has tried whether the file can be written, when it begins to write, and when it has written. */
    @Test
    void killedViewer_leavesTheOldFileOrTheNewOne_andTheNextOneClearsUp() throws Exception {
        try (Xvfb display = new Xvfb()) {
            for (int changes : new int[] {2, 3, 4}) {
                Files.writeString(shot, OLD);
                DirectoryChanges watched = new DirectoryChanges(shots);
                Process viewer = viewer(display, "shots/" + NAME).start();
                boolean killed = watched.killAfter(changes, viewer);
                assertTrue(killed || viewer.exitValue() == ExitCode.DONE, Program.rest(viewer));
                assertTrue(isNew() || killed);
            }
            Process next = viewer(display, "shots/" + NAME).start();
            assertEquals("", Program.rest(next));
            assertEquals(ExitCode.DONE, next.waitFor());
            assertTrue(isNew());
            assertEquals(List.of(NAME), names());
        }
    }

    @Test
    void fullDisk_keepsTheOldFile_andTheFileIsNamed() throws Exception {
        assertFails("cat /dev/zero >full/filler 2>/dev/null; ",
                "full/" + NAME + ": expected to be read and written, got No space left on device\n");
    }

    @Test
    void fileThatMayNotBeWritten_isRefused() throws Exception {
        assertFails(MountNamespace.readOnly("full/" + NAME),
                "full/" + NAME + ": expected a file that can be written, got one that cannot\n");
    }

    /** @param before shell commands that keep a file in the directory "full" from being written */
    private void assertFails(String before, String line) throws Exception {
        Files.createDirectory(directory.resolve("full"));
        String script = MountNamespace.disk("full", "shots") + before + "\"$@\"; code=$?; cp full/" + NAME
                + " shots; exit $code";
        try (Xvfb display = new Xvfb()) {
            ProcessBuilder viewer = viewer(display, "full/" + NAME);
            Process failing = viewer.command(MountNamespace.command(script, viewer.command())).start();
            assertEquals(line, Program.rest(failing));
            assertEquals(ExitCode.FILE, failing.waitFor());
        }
        assertArrayEquals(OLD.getBytes(), Files.readAllBytes(shot));
    }
}
