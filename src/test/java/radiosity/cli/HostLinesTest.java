package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.cli.render.HostLines;
import radiosity.cli.terminal.ProgressDisplay;
import radiosity.solution.HostStatistics;
import radiosity.solution.Progress;
import radiosity.solution.WorldStatistics;

/** The lines about hosts that stand between those about progress. */
class HostLinesTest {

    private static final long SECOND = 1_000_000_000L;

    private final List<String> lines = new ArrayList<>();
    private final ProgressDisplay display = new ProgressDisplay() {
        @Override
        public void phase(String name) { }

        @Override
        public void part(String name, double done, double all) { }

        @Override
        public void show(Progress progress) { }

        @Override
        public void message(String line) {
            lines.add(line);
        }

        @Override
        public void close() { }
    };

    @Test
    void everyHostHasALine_everyFiveSeconds() {
        WorldStatistics world = new WorldStatistics(List.of(
                new HostStatistics("andreas", "working", 12, 1464, 40, 3.21, 0.042, 1 << 20),
                new HostStatistics("igge", "lost", 0, 0, 10, 1, 0.5, 1 << 20)), 40, 4, 4, 1, 1);
        long[] now = {0};
        int[] told = {0};
        HostLines hosts = new HostLines(() -> world, display, progress -> ++told[0] < 4, () -> now[0]);
        boolean goOn = true;
        for (int second : new int[] {1, 5, 9, 12}) {
            now[0] = second * SECOND;
            goOn = hosts.afterRound(new Progress(second, second, 0.5, 1464, false));
        }
        assertEquals(4, told[0]);
        assertEquals(false, goOn);
        String andreas = "host andreas working: 12 blocks, 1464 elements, CPU 3.2 s, idle 4 %";
        String igge = "host igge lost: 0 blocks, 0 elements, CPU 1.0 s, idle 50 %";
        assertEquals(List.of(andreas, igge, andreas, igge), lines);
    }
}
