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
 * Calculates ever more exactly until a time limit ({@code --time}); the result is the last complete solution.
 *
 * <p>Time decides which accuracies are calculated, never the bits of a solution: each solution is the one that
 * {@code --accuracy} gives with the value that the scene file names. Each solution is saved as soon as it is complete.
 * If not even the first calculation ends in time, it is cut off after a shot, as by {@code -it}.
 */
public final class TimedCalculation {

    /** Part of the time limit that is reserved for writing the outputs. */
    private static final double RESERVE = 0.03;

    private final RenderJob calculation;
    private final RadiositySettings settings;
    private final TimeLimit limit;
    private final TimeCourse course;
    private final AccuracyChoice choice = new AccuracyChoice(Runtime.getRuntime().maxMemory());
    private final ConsoleSession user;
    private final StopRequest stop;
    private final OutputFiles files;
    /** The first calculation goes on beyond the limit until at most this part of the emitted flux is unshot. */
    private static final double LIT = 0.5;

    /** The current calculation. */
    private ProgressiveRadiosity current;
    /** Number of shots at the last check. */
    private int shots;
    /** Whether the limit has cut off the first calculation. */
    private boolean isCutOff;
    /** Whether the user has got the message that the first calculation takes longer than the limit. */
    private boolean isLate;
    private RenderResult best;
    /** The accuracies reached so far, as the user would write them. */
    private final List<String> reached = new ArrayList<>();
    /** The relative error asked for, and its text as the user would write it (100 times the error may be longer). */
    private double aim;
    private String perCent;
    /** Time left when the calculation of that accuracy began, s. */
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

    /**
     * Calculates until the limit, or beyond it until half of the light is distributed.
     *
     * @return the last complete solution, or the first one as far as it got
     */
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

    /** Keeps a solution that is as exact as was asked for, and chooses the next relative error; empty for none. */
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

    /** The value of {@code --accuracy} that reproduces the best solution. */
    private String accuracies() {
        return reached.isEmpty() ? perCent : String.join(",", reached);
    }

    private double left() {
        return course.left() - RESERVE * limit.seconds();
    }

    /** Cuts off right after a step that has shot, never after one that divides or gathers: {@code -it} ends there. */
    private boolean goesOn() {
        int before = shots;
        shots = current == null ? 0 : current.shots();
        if (stop.made() || left() > 0) {
            return !stop.made();
        }
        isCutOff = best == null && shots > before && current.progress().unsent() <= LIT;
        if (best == null && !isCutOff && !isLate) {
            isLate = true;
            user.message(TimeLimit.OPTION + " " + limit.text()
                    + ": too short for this scene; going on until half of its light is distributed");
        }
        return best == null && !isCutOff;
    }

    /** A line for the user: the time of the calculation, and the options that reproduce it to the last bit. */
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
