package radiosity.cli.terminal;

import java.util.function.LongSupplier;
import radiosity.settings.StopRule;
import radiosity.solution.Progress;

/** From the first progress seen to the stop rule, to the nearer of its two ends. */
public final class StopRuleCourse implements ProgressEstimate {

    private static final double NANOSECONDS = 1e9;
    /** A smaller part that is done says nothing about the rest: a first shot may change almost nothing. */
    private static final double LEAST_DONE = 1e-4;
    /** What the distribution of light is of the whole way; the estimate of the error and writing follow. */
    private static final double DISTRIBUTION = .95;
    /** Before, little is known, s. */
    private static final double LEAST_SECONDS = 5;

    private final StopRule stop;
    private final LongSupplier clock;
    private Progress first;
    private long start;

    /** @param clock nanoseconds, as {@link System#nanoTime} */
    public StopRuleCourse(StopRule stop, LongSupplier clock) {
        this.stop = stop;
        this.clock = clock;
    }

    @Override
    public double done(Progress now) {
        if (first == null) {
            first = now;
            start = clock.getAsLong();
        }
        double shots = part(now.shots() - first.shots(), (double) stop.shots() - first.shots());
        double unsent = part(StrictMath.log(first.unsent() / now.unsent()),
                StrictMath.log(first.unsent() / stop.unsent()));
        return DISTRIBUTION * Math.max(shots, unsent);
    }

    private static double part(double gone, double whole) {
        return whole > 0 && gone > 0 ? Math.min(1, gone / whole) : 0;
    }

    /** If it goes on as so far; 0 where little is known of that. */
    @Override
    public double left(Progress now) {
        double done = done(now);
        double elapsed = (clock.getAsLong() - start) / NANOSECONDS;
        return done >= LEAST_DONE && elapsed >= LEAST_SECONDS ? elapsed * (1 - done) / done : 0;
    }

    @Override
    public String label() {
        return "";
    }
}
