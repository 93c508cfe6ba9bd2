package radiosity.cli.terminal;

import java.util.Locale;
import radiosity.solution.Progress;

/**
 * Text about the progress of a render: the phase, the part that is done, and the time left. One text serves a whole
 * render, with all of its displays, as the part that is done never becomes smaller.
 */
public final class ProgressText {

    /** Percentages below this are rounding errors. */
    private static final double LEAST = 1e-8;
    private static final int LONGEST_BAR = 40;
    private static final int SHORTEST_BAR = 8;

    private final ProgressEstimate course;
    private String phase = "";
    private Progress latest;
    private double left;
    /** Part of the render that is done, in [0, 1], which only grows. */
    private double done;
    /** Part of the render that was done when the tasks after the calculation began; NaN before. */
    private double calculated = Double.NaN;
    /** Whether the phase is a task after the calculation, see {@link #part}. */
    private boolean isPart;

    public ProgressText(ProgressEstimate course) {
        this.course = course;
    }

    /** @param name of the phase that begins */
    public void phase(String name) {
        phase = name;
        latest = null;
        isPart = false;
    }

    /**
     * @param name of a task after the calculation
     * @param part of the task that is done; limited to [0, 1]
     * @param all  part of all tasks after the calculation that is done, which are the rest of the render; limited to
     *             [0, 1]
     */
    public void part(String name, double part, double all) {
        phase(name + " (" + share(limited(part)) + " of it)");
        isPart = true;
        calculated = Double.isNaN(calculated) ? done : calculated;
        done = Math.max(done, calculated + (1 - calculated) * limited(all));
    }

    private static double limited(double part) {
        return Math.max(0, Math.min(1, part));
    }

    /** Takes the progress after a round. */
    public void show(Progress progress) {
        latest = progress;
        phase = progress.shots() == 0 ? "preparing" : progress.gathers() ? "refining the mesh" : "distributing light";
        done = Math.max(done, Math.min(1, course.done(progress)));
        left = course.left(progress);
    }

    /** The progress as a line of a log file. */
    public String line() {
        return course.label() + phase + (latest != null || isPart ? ", " + share(done) : "")
                + (latest == null ? "" : ": " + details() + time());
    }

    /**
     * The progress as a line of a terminal, with a bar. Where the line is too narrow, the numbers of shots and elements
     * are left out first, then the bar, then the end of the phase.
     *
     * @param width largest number of characters of the line
     */
    public String bar(int width) {
        String head = course.label() + phase;
        String tail = " " + share(done) + (latest == null ? "" : time());
        int room = width - head.length() - tail.length() - " []".length();
        int bar = Math.min(LONGEST_BAR, room);
        String details = latest == null || room - bar < details().length() + 2 ? "" : ", " + details();
        String full = bar < SHORTEST_BAR ? "" : " [" + "#".repeat((int) (done * bar))
                + " ".repeat(bar - (int) (done * bar)) + "]";
        int kept = Math.max(0, Math.min(head.length(), width - tail.length()));
        String line = head.substring(0, kept) + full + tail + details;
        return line.substring(0, Math.min(width, line.length()));
    }

    private static String share(double part) {
        return (int) (100 * part) + " %";
    }

    private String details() {
        return count(latest.shots(), "shot") + ", " + perCent(latest.unsent()) + " not yet distributed, "
                + count(latest.elements(), "mesh element")
                + (Double.isNaN(latest.error()) ? "" : ", +- " + perCent(latest.error()));
    }

    private String time() {
        if (left <= 0) {
            return "";
        }
        return latest.error() > course.asked() ? ", " + perCent(course.asked()) + " in about " + time(left)
                : ", " + time(left) + " left";
    }

    /** A number of things in words, such as "1 shot" and "2,048 shots". */
    public static String count(int number, String thing) {
        return String.format(Locale.ROOT, "%,d %s%s", number, thing, number == 1 ? "" : "s");
    }

    /** A part of 1 as a percentage with two significant digits; rounding errors become "0 %". */
    public static String perCent(double part) {
        return perCent(part, 2);
    }

    /** A part of 1 as a percentage with some significant digits; rounding errors become "0 %". */
    public static String perCent(double part, int digits) {
        double value = 100 * part;
        int decimals = value >= LEAST ? (int) Math.max(0, digits - 1 - Math.floor(StrictMath.log10(value))) : 0;
        return String.format(Locale.ROOT, "%." + decimals + "f %%", value);
    }

    /** A duration in seconds in words, such as "5 s" and "2 h 3 min". */
    public static String time(double seconds) {
        long s = Math.round(seconds);
        if (s < 60) {
            return s + " s";
        }
        return s < 3600 ? s / 60 + " min " + s % 60 + " s" : s / 3600 + " h " + s / 60 % 60 + " min";
    }
}
