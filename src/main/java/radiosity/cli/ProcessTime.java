package radiosity.cli;

import java.time.Duration;
import java.time.Instant;

/** Wall time of this process. */
final class ProcessTime {

    private ProcessTime() { }

    /** Since the process began. */
    static double seconds() {
        Instant now = Instant.now();
        Instant start = ProcessHandle.current().info().startInstant().orElse(now);
        return Duration.between(start, now).toMillis() / 1000.0;
    }
}
