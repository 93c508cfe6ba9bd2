package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.render.SavedCalculation;
import radiosity.testkit.ProgramRun;

/** What {@code --change} takes over, and what it says where it cannot. */
@Tag("slow")
class ChangeOptionTest {

    private static final String EMPTY = "scenes/cornell-box-empty.lws";
    private static final String BOX = "scenes/cornell-box.lws";

    @TempDir
    Path directory;

    private ProgramRun render(Object... arguments) {
        Object[] words = new Object[arguments.length + 3];
        words[0] = "-q";
        words[1] = "-pa";
        words[2] = "20000";
        System.arraycopy(arguments, 0, words, 3, arguments.length);
        ProgramRun run = ProgramRun.of(words);
        assertEquals(0, run.exitCode(), run.err());
        return run;
    }

    @Test
    void oldSolution_isTakenOverOrALineSaysWhyNot() throws IOException {
        Path old = directory.resolve("old.scene");
        Path paper = directory.resolve("paper.scene");
        Path now = directory.resolve("now.scene");
        render("--accuracy", "50%", EMPTY, old);
        render("-it", "5", EMPTY, paper);

        assertEquals("", render("--change", old, EMPTY, now).err());
        assertEquals(SavedCalculation.read(old).state(), SavedCalculation.read(now).state());
        assertEquals("", render("--change", old, BOX, now).err());

        assertEquals(old + ": the scene is rendered anew, as the old solution was made with other settings\n",
                render("--change", old, "--accuracy", "40%", BOX, now).err());
        assertEquals(paper + ": the scene is rendered anew, as only solutions of --schedule predict and --form-factors"
                + " raycast are changed\n", render("--change", paper, "-it", "5", BOX, now).err());
    }

    @Test
    void filesThatAreNone_areErrors() {
        Path none = directory.resolve("none.scene");
        ProgramRun run = ProgramRun.of("--change", none, EMPTY, directory.resolve("a.scene"));
        assertEquals(3, run.exitCode());
        assertTrue(run.err().startsWith(none.toString()), run.err());
        assertEquals(3, ProgramRun.of("--change", EMPTY, EMPTY, directory.resolve("a.scene")).exitCode());
        assertEquals(2, ProgramRun.of("--change", none, "-tf", none, EMPTY, directory.resolve("a.scene")).exitCode());
    }
}
