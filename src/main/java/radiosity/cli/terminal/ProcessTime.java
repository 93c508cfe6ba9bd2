package radiosity.cli.terminal;

import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.time.Instant;

/** Wall time of this process. */
public final class ProcessTime {

    private ProcessTime() { }

    /** Seconds since the process began; since the JVM began, where scripts/start.sh first built the program. */
    public static double seconds() {
        Instant now = Instant.now();
        return Duration.between(start(now), now).toMillis() / 1000.0;
    }

    private static Instant start(Instant now) {
        return Boolean.getBoolean("radiosity.built")
                ? Instant.ofEpochMilli(ManagementFactory.getRuntimeMXBean().getStartTime())
                : ProcessHandle.current().info().startInstant().orElse(now);
    }
}
