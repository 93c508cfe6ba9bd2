package radiosity.cli.terminal;

import java.util.Locale;
import radiosity.solution.Progress;

/** How far a calculation is, in words, with the time it will still take. */
public final class ProgressText {

    /** Below this, per cent, is rounding only. */
    private static final double LEAST = 1e-8;

    private final ProgressEstimate course;

    public ProgressText(ProgressEstimate course) {
        this.course = course;
    }

    /** Part of the way, in [0, 1]. */
    double done(Progress now) {
        return course.done(now);
    }

    public String of(Progress now) {
        double left = course.left(now);
        return course.label() + now.shots() + (now.shots() == 1 ? " shot, " : " shots, ") + perCent(now.unsent())
                + " unsent, " + now.elements() + (now.gathers() ? " elements, the new ones gather" : " elements")
                + (left > 0 ? ", " + time(left) + " left" : "");
    }

    /** So many of a thing. */
    public static String count(int number, String thing) {
        return String.format(Locale.ROOT, "%,d %s%s", number, thing, number == 1 ? "" : "s");
    }

    /** Two digits that count; rounding errors are 0. */
    public static String perCent(double part) {
        double value = 100 * part;
        int decimals = value >= LEAST ? (int) Math.max(0, 1 - Math.floor(StrictMath.log10(value))) : 0;
        return String.format(Locale.ROOT, "%." + decimals + "f %%", value);
    }

    /** In words, from seconds. */
    public static String time(double seconds) {
        long s = Math.round(seconds);
        if (s < 60) {
            return s + " s";
        }
        return s < 3600 ? s / 60 + " min " + s % 60 + " s" : s / 3600 + " h " + s / 60 % 60 + " min";
    }
}
