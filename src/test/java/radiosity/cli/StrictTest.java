package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.options.ExitCode;
import radiosity.output.gltf.SceneFile;
import radiosity.testkit.ProgramRun;

/** What a scene is warned of is rendered all the same, and is exit code 3 with --strict. */
class StrictTest {

    private static final String DARK =
            "dark.lws: expected a light or a surface that emits, got none: all will be black";

    @TempDir
    Path directory;

    private ProgramRun render(Path scene, String... options) {
        Object[] all = {"-q", "-pa", "20000", "-it", "1", scene, directory.resolve("box.scene")};
        Object[] more = new Object[options.length + all.length];
        System.arraycopy(options, 0, more, 0, options.length);
        System.arraycopy(all, 0, more, options.length, all.length);
        return ProgramRun.of(more);
    }

    private void isRefused(ProgramRun run) {
        assertEquals(ExitCode.FILE, run.exitCode());
        assertEquals(1, run.err().lines().count(), run.err());
        assertFalse(Files.exists(directory.resolve("box.scene")));
    }

    /** The Cornell box with another value in all sub-chunks of a name in which there is a share above 0. */
    private Path box(String name, String chunk, float value) throws IOException {
        byte[] object = Files.readAllBytes(Path.of("scenes/cornell-box.lwo"));
        byte[] head = chunk.getBytes(StandardCharsets.US_ASCII);
        for (int i = 0; i + 10 < object.length; i++) {
            ByteBuffer at = ByteBuffer.wrap(object, i, 10);
            if (ByteBuffer.wrap(head).equals(at.slice().limit(4)) && at.getFloat(i + 6) > 0) {
                at.putFloat(i + 6, value);
            }
        }
        Files.write(directory.resolve("cornell-box.lwo"), object);
        return Files.copy(Path.of("scenes/cornell-box.lws"), directory.resolve(name));
    }

    @Test
    void sceneWithoutLight_isWarnedOfAndBlack() throws IOException {
        ProgramRun run = render(box("dark.lws", "LUMI", 0));
        assertEquals(ExitCode.DONE, run.exitCode(), run.err());
        assertEquals("warning: " + DARK + System.lineSeparator(), run.err());
        try (SceneFile scene = SceneFile.open(directory.resolve("box.scene"))) {
            assertEquals(0, scene.ledger().emitted()[0]);
        }
    }

    @Test
    void sceneWithoutLight_isRefusedWithStrict() throws IOException {
        ProgramRun run = render(box("dark.lws", "LUMI", 0), "--strict");
        isRefused(run);
        assertEquals(DARK + System.lineSeparator(), run.err());
    }

    @Test
    void reflectanceOf1AndMore_isWarnedOfAndTakenAsLess() throws IOException {
        ProgramRun run = render(box("white.lws", "DIFF", 3));
        assertEquals(ExitCode.DONE, run.exitCode(), run.err());
        assertTrue(run.err().startsWith("warning: white.lws: reflectances of 1 and more are taken as 0.9999: "),
                run.err());
    }

    @Test
    void reflectanceOf1AndMore_isRefusedWithStrict() throws IOException {
        ProgramRun run = render(box("white.lws", "DIFF", 3), "--strict");
        isRefused(run);
        assertTrue(run.err().startsWith("white.lws: expected no warning (--strict), got reflectances of 1 and more"
                + " are taken as 0.9999: "), run.err());
    }
}
