package radiosity.cli.terminal;

import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.time.Instant;
import java.util.function.DoubleSupplier;
import radiosity.solution.Progress;

/** Estimates progress by a time limit, from the start of the process to the end of the limit. */
public final class TimeCourse implements ProgressEstimate {

    private final double seconds;
    private final DoubleSupplier gone;
    private String label = "";

    /**
     * @param seconds the time limit, above 0
     * @param gone    supplies the seconds since the process began
     */
    public TimeCourse(double seconds, DoubleSupplier gone) {
        this.seconds = seconds;
        this.gone = gone;
    }

    /** Rest of the time limit, s; negative after its end. */
    public double left() {
        return seconds - gone.getAsDouble();
    }

    @Override
    public double done(Progress now) {
        return Math.min(1, gone.getAsDouble() / seconds);
    }

    @Override
    public double left(Progress now) {
        return Math.max(0, left());
    }

    @Override
    public double asked() {
        return Double.NaN;
    }

    /** @param accuracy of the current calculation, as the user would write it; becomes the label */
    public void at(String accuracy) {
        label = "at " + accuracy + ": ";
    }

    @Override
    public String label() {
        return label;
    }

    /** Seconds since the process began; since the JVM began, where scripts/start.sh first built the program. */
    public static double ofProcess() {
        Instant now = Instant.now();
        Instant start = Boolean.getBoolean("radiosity.built")
                ? Instant.ofEpochMilli(ManagementFactory.getRuntimeMXBean().getStartTime())
                : ProcessHandle.current().info().startInstant().orElse(now);
        return Duration.between(start, now).toMillis() / 1000.0;
    }
}
