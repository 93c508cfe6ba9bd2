package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.cli.options.ExitCode;
import radiosity.cli.options.Failure;
import radiosity.cli.render.Failures;

/** An output that fails, in whatever way, stops no other output, and is told at the end. */
class FailuresTest {

    @Test
    void everyOutputIsAttempted_andEveryFailureTold() {
        Failures failures = new Failures();
        List<String> written = new ArrayList<>();
        assertFalse(failures.tried(() -> {
            throw new IOException("no space");
        }));
        assertFalse(failures.tried(() -> {
            throw new IllegalStateException("a mistake of the program");
        }));
        assertTrue(failures.tried(() -> written.add("report")));
        assertEquals(List.of("report"), written);
        Failure all = assertThrows(Failure.class, failures::check);
        assertEquals(ExitCode.FILE, all.exitCode());
        assertEquals(2, all.getMessage().lines().count(), all.getMessage());
        assertTrue(all.getMessage().contains("a mistake of the program"), all.getMessage());
    }

    @Test
    void withoutFailures_nothingIsTold() {
        Failures failures = new Failures();
        failures.tried(() -> { });
        failures.check();
    }
}
