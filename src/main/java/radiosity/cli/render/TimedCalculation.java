package radiosity.cli.render;

import java.io.IOException;
import java.util.Locale;
import java.util.Optional;
import radiosity.cli.options.ErrorReport;
import radiosity.cli.options.TimeLimit;
import radiosity.cli.options.Values;
import radiosity.cli.terminal.StopRequest;
import radiosity.cli.terminal.TimeCourse;
import radiosity.master.host.NoWorkerException;
import radiosity.settings.RadiositySettings;
import radiosity.solver.ProgressiveRadiosity;

/**
 * Calculates ever more exactly until the time is up ({@code --time}); what counts is the last solution that is whole.
 *
 * <p>Time chooses the accuracies, never the bits: each solution is the one that {@code --accuracy} gives, and the
 * scene file says which. Each is saved as soon as it is there. Where not even the first calculation is done in time, it
 * is cut off after a shot, as by {@code -it}.
 */
public final class TimedCalculation {

    /** Time that is kept for what follows, part of the limit. */
    private static final double RESERVE = 0.03;

    private final RenderJob calculation;
    private final RadiositySettings settings;
    private final TimeLimit limit;
    private final TimeCourse course;
    private final AccuracyChoice choice = new AccuracyChoice(Runtime.getRuntime().maxMemory());
    private final ConsoleSession user;
    private final StopRequest stop;
    private final OutputFiles files;
    /** The first calculation goes on beyond the limit until no more of the emitted flux than this is unsent. */
    private static final double LIT = 0.5;

    /** The calculation that is under way. */
    private ProgressiveRadiosity current;
    /** Patches that had shot when this was asked last. */
    private int shots;
    /** Whether the limit has cut off the first calculation. */
    private boolean isCutOff;
    /** Whether the user knows that the first calculation takes longer than the limit. */
    private boolean isLate;
    private RenderResult best;
    /** Its accuracy, as the user would write it. */
    private String reached;

    public TimedCalculation(RenderJob calculation, RadiositySettings settings, TimeLimit limit, TimeCourse course,
                     ConsoleSession user, StopRequest stop, OutputFiles files) {
        this.calculation = calculation;
        this.settings = settings;
        this.limit = limit;
        this.course = course;
        this.user = user;
        this.stop = stop;
        this.files = files;
    }

    /** The best that was done: at least the first calculation until there is some light, however long that takes. */
    public RenderResult run() throws IOException {
        double accuracy = AccuracyChoice.COARSEST;
        while (accuracy > 0) {
            accuracy = tried(TimeLimit.perCent(accuracy)) ? choice.next(left()) : 0;
        }
        return best;
    }

    private double left() {
        return course.left() - RESERVE * limit.seconds();
    }

    /** Whether a calculation came to its end. */
    private boolean tried(String perCent) throws IOException {
        course.at(perCent);
        double begin = course.left();
        double accuracy = new Values.PerCent().convert(perCent);
        RenderResult result;
        try {
            result = calculation.run(settings.accurate(accuracy), radiosity -> current = radiosity, Optional.empty(),
                    this::goesOn);
        } catch (NoWorkerException | OutOfMemoryError e) {
            if (best == null) {
                throw e;
            }
            user.message(perCent + ": " + ErrorReport.line(e));
            return false;
        }
        if (best == null || !result.isCut()) {
            best = result;
            reached = perCent;
            OutputFiles to = isCutOff ? files.cutOff(perCent, result.progress().shots()) : files.accurate(perCent);
            to.saveScene(result.solution(), result.settings(), result.certificate());
        }
        choice.took(accuracy, begin - course.left(), result.progress().elements());
        return !result.isCut();
    }

    private boolean goesOn() {
        if (stop.made() || left() > 0) {
            return !stop.made();
        }
        int before = shots;
        shots = current.shots();
        isCutOff = best == null && shots > before && current.progress().unsent() <= LIT;
        if (best == null && !isCutOff && !isLate) {
            isLate = true;
            user.message(TimeLimit.OPTION + " " + limit.text()
                    + ": too short for this scene; going on until half of its light is distributed");
        }
        return best == null && !isCutOff;
    }

    /** For the user: in what time what was done, and how to do it again to the last bit. */
    public String summary() {
        String time = seconds(limit.seconds() - course.left());
        if (isCutOff) {
            return TimeLimit.OPTION + " " + limit.text() + ": too short for this scene, cut off after " + time
                    + "; the same as with " + String.join(" ", TimeLimit.cutOff(reached, best.progress().shots()));
        }
        return TimeLimit.OPTION + " " + limit.text() + ": "
                + (best.isCut() ? "stopped after " + time + " in the first calculation, the one of --accuracy "
                : whole(time) + "; the same as with --accuracy ") + reached;
    }

    private String whole(String time) {
        return (stop.made() ? "stopped after " : "done in ") + time;
    }

    private static String seconds(double seconds) {
        return String.format(Locale.ROOT, "%.3g s", seconds);
    }
}
