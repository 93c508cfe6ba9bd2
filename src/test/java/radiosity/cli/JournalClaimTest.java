package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.options.ExitCode;
import radiosity.cli.options.Failure;
import radiosity.cli.render.Journal;
import radiosity.cli.render.JournalClaim;
import radiosity.testkit.Program;

/** A journal belongs to one live process. */
@Tag("slow")
@Timeout(value = 2, unit = TimeUnit.MINUTES, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class JournalClaimTest {

    private static final String RENDER = "--schedule paper -pa 300 -se 0 foobar.lws foobar.scene";

    @TempDir
    Path directory;

    private Path scene;

    @BeforeEach
    void nameScene() {
        scene = directory.resolve("foobar.scene");
    }

    @Test
    void journalInUse_isRefused_andFreeAfterwards() throws IOException {
        Path journal = Journal.of(scene);
        try (JournalClaim claim = JournalClaim.of(journal)) {
            Failure failure = assertThrows(Failure.class, () -> JournalClaim.of(journal));
            assertEquals(ExitCode.FILE, failure.exitCode());
            JournalClaim.of(Journal.of(directory.resolve("other.scene"))).close();
            assertEquals(journal, claim.journal());
        }
        JournalClaim.of(journal).close();
    }

    /** Also when the first one is killed, which ends its claim and leaves the file of it. */
    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no signals")
    void secondRenderToOneOutput_isRefusedWhileTheFirstOneLives() throws Exception {
        Program program = new Program(directory);
        Process first = program.start(RENDER);
        Program.readUntil(first, "distributing");
        await(Journal.of(scene));
        Process second = program.start(RENDER);
        assertEquals("foobar.scene.journal: expected a journal that no other render is using, got that of process "
                + first.pid() + ", which is running" + System.lineSeparator(), Program.rest(second));
        assertEquals(ExitCode.FILE, second.waitFor());
        assertTrue(Files.exists(Journal.of(scene)));
        first.destroyForcibly().waitFor();

        Process third = program.start(RENDER);
        String begin = Program.readUntil(third, "cut off");
        assertTrue(begin.contains("foobar.scene.journal: going on after "), begin);
        Program.readUntil(third, "distributing");
        new ProcessBuilder("kill", "-TERM", Long.toString(third.pid())).start().waitFor();
        Program.rest(third);
        assertEquals(143, third.waitFor());
        try (Stream<Path> files = Files.list(directory)) {
            assertEquals(Set.of("cornell-box.lwo", "foobar.lws", "foobar.scene"),
                    files.map(file -> file.getFileName().toString()).collect(Collectors.toSet()));
        }
    }

    private static void await(Path file) throws InterruptedException {
        while (Files.notExists(file)) {
            Thread.sleep(10);
        }
    }
}
