package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.cli.render.RenderJob;

/** Notices about hosts in a program that calculates several times, as with {@code --time}. */
class CalculationTest {

    private static final String MISSING = "host igge: no connection; starting without it";
    private static final String JOINED = "host igge joined";

    private final List<String> said = new ArrayList<>();
    private final RenderJob.HostNotices notices = new RenderJob.HostNotices(said::add);

    private void open(String... lines) throws IOException {
        notices.whileOpening(() -> {
            List.of(lines).forEach(notices);
            return null;
        });
    }

    @Test
    void hostThatStaysMissing_isNamedOnce() throws IOException {
        open(MISSING);
        open(MISSING);
        open(MISSING, "host daniel: no connection; starting without it");
        assertEquals(List.of(MISSING, "host daniel: no connection; starting without it"), said);
    }

    @Test
    void hostThatWasThereMeanwhile_isNamedAgain() throws IOException {
        open(MISSING);
        notices.accept(JOINED);
        open(MISSING);
        assertEquals(List.of(MISSING, JOINED, MISSING), said);
    }

    @Test
    void eventsWhileCalculating_areAllNamed() throws IOException {
        open();
        notices.accept(JOINED);
        notices.accept(JOINED);
        assertEquals(List.of(JOINED, JOINED), said);
    }
}
