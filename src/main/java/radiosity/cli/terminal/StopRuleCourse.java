package radiosity.cli.terminal;

import java.util.function.LongSupplier;
import radiosity.settings.StopRule;
import radiosity.solution.Progress;

/**
 * Estimates progress by the stop rule, from the first progress seen to the nearer of the rule's two limits. Where the
 * latest estimate of the error is larger than the error asked for, progress is estimated from the two errors instead.
 */
public final class StopRuleCourse implements ProgressEstimate {

    private static final double NANOSECONDS = 1e9;
    /** Least part done from which the time left is estimated, as a first shot may change almost nothing. */
    private static final double LEAST_DONE = 1e-4;
    /** Part of the render that is distribution of light; the estimate of the error and the writing of files follow. */
    private static final double DISTRIBUTION = .95;
    /** Least time after which the time left is estimated, s. */
    private static final double LEAST_SECONDS = 5;

    /**
     * Time grows with this power of 1 / error: N elements leave an error of about 1 / N and each gathers with more
     * rays.
     */
    private static final double POWER = 1.5;

    private final StopRule stop;
    private final double asked;
    private final LongSupplier clock;
    private Progress first;
    private long start;
    /** The latest error found, and the time of the whole calculation predicted from it, s. */
    private double error = Double.NaN;
    private double whole;

    /**
     * @param asked relative error at which the calculation ends; NaN: by the stop rule only
     * @param clock nanoseconds, as {@link System#nanoTime}
     */
    public StopRuleCourse(StopRule stop, double asked, LongSupplier clock) {
        this.stop = stop;
        this.asked = asked;
        this.clock = clock;
    }

    @Override
    public double done(Progress now) {
        if (first == null) {
            first = now;
            start = clock.getAsLong();
        }
        if (now.error() > asked) {
            return Math.min(DISTRIBUTION, elapsed() / whole(now));
        }
        double shots = part(now.shots() - first.shots(), (double) stop.shots() - first.shots());
        double unsent = part(StrictMath.log(first.unsent() / now.unsent()),
                StrictMath.log(first.unsent() / stop.unsent()));
        return DISTRIBUTION * Math.max(shots, unsent);
    }

    /** A way is done where as much is gone as the whole, both infinite among it, and not begun where either is 0. */
    private static double part(double gone, double whole) {
        return whole > 0 && gone > 0 ? gone >= whole ? 1 : gone / whole : 0;
    }

    /** The time left at the speed so far, s; 0 where too little is done to know. */
    @Override
    public double left(Progress now) {
        double done = done(now);
        double elapsed = elapsed();
        return done >= LEAST_DONE && elapsed >= LEAST_SECONDS ? elapsed * (1 - done) / done : 0;
    }

    private double elapsed() {
        return (clock.getAsLong() - start) / NANOSECONDS;
    }

    private double whole(Progress now) {
        if (now.error() != error) {
            error = now.error();
            whole = elapsed() * StrictMath.pow(error / asked, POWER);
        }
        return whole;
    }

    @Override
    public double asked() {
        return asked;
    }

    @Override
    public String label() {
        return "";
    }
}
