package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import radiosity.testkit.NeedsProgram;
import radiosity.testkit.Program;

/** The bar on a terminal, from the reading of the scene to the last picture. */
@Tag("slow")
@NeedsProgram("python3")
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "has no pseudo terminals")
class WholeRenderProgressTest {

    private static final Pattern BAR = Pattern.compile("([a-z][^\\[\\r]*) \\[#* *] (\\d+) %");

    @TempDir
    Path directory;

    @Test
    void share_neverGoesBack_betweenPhasesAndPictures() throws Exception {
        Program program = new Program(directory);
        List<String> command = new ArrayList<>(List.of("python3", "-c",
                "import pty,sys; sys.exit(pty.spawn(sys.argv[1:]))"));
        command.addAll(Program.command("--accuracy 5% --picture a.png --picture b.png --size 200x200 --final-gather 40"
                + " foobar.lws foobar.scene"));
        Process render = program.start(command);
        String printed = Program.rest(render);
        assertEquals(0, render.waitFor(), printed);
        Set<String> phases = new TreeSet<>();
        int before = 0;
        Matcher bar = BAR.matcher(printed);
        while (bar.find()) {
            int share = Integer.parseInt(bar.group(2));
            assertTrue(share >= before, "after " + before + " %: " + bar.group());
            before = share;
            phases.add(bar.group(1).replaceFirst(" \\(\\d+ % of it\\)", ""));
        }
        assertTrue(before >= 99, before + " % at the end");
        // the bar is drawn anew some times a second, so that a phase may be too short to be seen
        assertTrue(phases.containsAll(List.of("distributing light", "drawing a.png", "drawing b.png")),
                phases.toString());
    }
}
