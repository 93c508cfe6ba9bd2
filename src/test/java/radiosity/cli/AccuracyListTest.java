package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.options.ExitCode;
import radiosity.cli.render.SavedCalculation;
import radiosity.solution.SavedState;
import radiosity.testkit.ProgramRun;

/** {@code --accuracy 50%,20%}: one accuracy after the other. */
@Tag("slow")
class AccuracyListTest {

    private static final String LIST = "--accuracy 50%,20%";

    @TempDir
    Path directory;

    private SavedState render(String options, String output) throws IOException {
        Path file = directory.resolve(output);
        List<Object> arguments = new ArrayList<>(List.of("-q", "-pa", "20000"));
        arguments.addAll(List.of(options.split(" ")));
        arguments.addAll(List.of("scenes/cornell-box-empty.lws", file));
        ProgramRun run = ProgramRun.of(arguments.toArray());
        assertEquals(ExitCode.DONE, run.exitCode(), run.err());
        return SavedCalculation.read(file).state();
    }

    /** A stop by -it is before the first accuracy: the next one is not asked for yet. */
    @Test
    void stoppedBeforeTheFirst_goesOnToTheSameBits() throws IOException {
        SavedState whole = render(LIST, "whole.scene");
        assertNotEquals(render("--accuracy 50%", "first.scene"), whole);
        for (int shots : new int[] {1, 10}) {
            render("--schedule predict -it " + shots + " " + LIST, "part.scene");
            assertEquals(whole, render(LIST + " -tf " + directory.resolve("part.scene") + " " + shots, "on.scene"));
        }
    }

    /** Who finds a file not exact enough asks for a smaller error, as if both had been asked for at first. */
    @Test
    void smallerErrorThanThatOfTheFile_goesOnToTheSameBits() throws IOException {
        SavedState whole = render(LIST, "whole.scene");
        render("--accuracy 50%", "first.scene");
        assertEquals(whole, render("--accuracy 20% -tf " + directory.resolve("first.scene"), "on.scene"));
    }
}
