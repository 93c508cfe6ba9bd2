package radiosity.cli;

import java.util.Locale;
import java.util.function.LongSupplier;
import radiosity.world.Progress;
import radiosity.world.StopRule;

/** How far a calculation is, in words, with the time it will still take if it goes on as so far. */
final class ProgressText {

    private static final double NANOSECONDS = 1e9;
    /** Below this, per cent, is rounding only. */
    private static final double LEAST = 1e-8;

    private final StopRule stop;
    private final LongSupplier clock;
    private final long start;
    private Progress first;

    /** @param clock nanoseconds, as {@link System#nanoTime} */
    ProgressText(StopRule stop, LongSupplier clock) {
        this.stop = stop;
        this.clock = clock;
        start = clock.getAsLong();
    }

    /** Part of the way from the first progress seen to the stop rule, in [0, 1]: the nearer of its two ends. */
    double done(Progress now) {
        if (first == null) {
            first = now;
        }
        double shots = part(now.shots() - first.shots(), (double) stop.shots() - first.shots());
        double unsent = part(Math.log(first.unsent() / now.unsent()), Math.log(first.unsent() / stop.unsent()));
        return Math.max(shots, unsent);
    }

    private static double part(double gone, double whole) {
        return whole > 0 && gone > 0 ? Math.min(1, gone / whole) : 0;
    }

    String of(Progress now) {
        return now.shots() + (now.shots() == 1 ? " shot, " : " shots, ") + perCent(now.unsent()) + " unsent, "
                + now.elements() + " elements" + left(now);
    }

    private String left(Progress now) {
        double done = done(now);
        double elapsed = (clock.getAsLong() - start) / NANOSECONDS;
        return done > 0 && done < 1 ? ", " + time(elapsed * (1 - done) / done) + " left" : "";
    }

    /** So many of a thing. */
    static String count(int number, String thing) {
        return String.format(Locale.ROOT, "%,d %s%s", number, thing, number == 1 ? "" : "s");
    }

    /** Two digits that count; rounding errors are 0. */
    static String perCent(double part) {
        double value = 100 * part;
        int decimals = value >= LEAST ? (int) Math.max(0, 1 - Math.floor(Math.log10(value))) : 0;
        return String.format(Locale.ROOT, "%." + decimals + "f %%", value);
    }

    /** In words, from seconds. */
    static String time(double seconds) {
        long s = Math.round(seconds);
        if (s < 60) {
            return s + " s";
        }
        return s < 3600 ? s / 60 + " min " + s % 60 + " s" : s / 3600 + " h " + s / 60 % 60 + " min";
    }
}
