package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.cli.options.ExitCode;
import radiosity.testkit.Program;
import radiosity.testkit.ProgramRun;

/** {@code -se}: the program says where less cannot be left than is. */
class StopErrorTest {

    @TempDir
    Path directory;

    @ParameterizedTest
    @CsvSource({"paper, 0, true", "matrix, 0, true", "paper, 1e-3, false"})
    void roundingOnly_isSaid(String schedule, String unsent, boolean expected) throws IOException {
        Program program = new Program(directory);
        ProgramRun run = ProgramRun.of("-q", "--schedule", schedule, "-se", unsent, "-pa", "100%",
                program.file("foobar.lws"),
                program.file("foobar.scene"));
        assertEquals(ExitCode.DONE, run.exitCode(), run.err());
        assertEquals(expected, run.out().contains("-se: what is not yet distributed is only rounding; no calculation leaves less"),
                run.out());
    }
}
