package radiosity.cli.render;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
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
    /** The accuracies that were reached, as the user would write them. */
    private final List<String> reached = new ArrayList<>();
    /** The relative error that is asked for now, and as the user would write it: 100 times it may be a digit more. */
    private double aim;
    private String perCent;
    /** Time that was left when that began, s. */
    private double begin;

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

    /** The best that was done: at least the first solution until there is some light, however long that takes. */
    public RenderResult run() throws IOException {
        aim(TimeLimit.perCent(AccuracyChoice.COARSEST));
        try {
            RenderResult last = calculation.run(settings.accurate(aim),
                    radiosity -> current = radiosity, this::after, Optional.empty(), this::goesOn);
            if (best == null) {
                keep(last);
            }
        } catch (NoWorkerException | OutOfMemoryError e) {
            if (best == null) {
                throw e;
            }
            user.message(perCent + ": " + ErrorReport.line(e));
        }
        return best;
    }

    private void aim(String next) {
        perCent = next;
        aim = new Values.PerCent().convert(next);
        begin = course.left();
        course.at(next);
    }

    /** Told of a solution that is as exact as was asked for: how exact the next one is to be. */
    private OptionalDouble after(RenderResult result) throws IOException {
        reached.add(perCent);
        keep(result);
        choice.took(aim, begin - course.left(), result.progress().elements());
        double next = choice.next(left());
        if (next == 0) {
            return OptionalDouble.empty();
        }
        aim(TimeLimit.perCent(next));
        return OptionalDouble.of(aim);
    }

    private void keep(RenderResult result) throws IOException {
        best = result;
        OutputFiles to = isCutOff ? files.cutOff(perCent, result.progress().shots())
                : files.accurate(accuracies());
        to.saveScene(result.solution(), result.settings(), result.certificate());
    }

    /** What {@code --accuracy} gives the same with. */
    private String accuracies() {
        return reached.isEmpty() ? perCent : String.join(",", reached);
    }

    private double left() {
        return course.left() - RESERVE * limit.seconds();
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
                    + "; the same as with "
                    + String.join(" ", TimeLimit.cutOff(perCent, best.progress().shots()));
        }
        return TimeLimit.OPTION + " " + limit.text() + ": "
                + (best.isCut() ? "stopped after " + time + " in the first calculation, the one of --accuracy "
                : whole(time) + "; the same as with --accuracy ") + accuracies();
    }

    private String whole(String time) {
        return (stop.made() ? "stopped after " : "done in ") + time;
    }

    private static String seconds(double seconds) {
        return String.format(Locale.ROOT, "%.3g s", seconds);
    }
}
