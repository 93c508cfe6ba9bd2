package radiosity.cli.terminal;

import java.util.function.LongSupplier;
import radiosity.settings.StopRule;
import radiosity.solution.Progress;

/**
 * From the first progress seen to the stop rule, to the nearer of its two ends; then, where the error that was found is
 * larger than the one that is asked for, to that.
 */
public final class StopRuleCourse implements ProgressEstimate {

    private static final double NANOSECONDS = 1e9;
    /** A smaller part that is done says nothing about the rest: a first shot may change almost nothing. */
    private static final double LEAST_DONE = 1e-4;
    /** What the distribution of light is of the whole way; the estimate of the error and writing follow. */
    private static final double DISTRIBUTION = .95;
    /** Before, little is known, s. */
    private static final double LEAST_SECONDS = 5;

    /** Time grows with this power of 1 / error: N elements leave about 1 / N of it, and each gathers with more rays. */
    private static final double POWER = 1.5;

    private final StopRule stop;
    private final double asked;
    private final LongSupplier clock;
    private Progress first;
    private long start;
    /** The error that was found last, and the time that all will take by it, s. */
    private double error = Double.NaN;
    private double whole;

    /**
     * @param asked relative error at which it ends; NaN: the stop rule only
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

    private static double part(double gone, double whole) {
        return whole > 0 && gone > 0 ? Math.min(1, gone / whole) : 0;
    }

    /** If it goes on as so far; 0 where little is known of that. */
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
